// How the contours of one glyph become those of another.
#pragma once

#include <algorithm>
#include <vector>

#include "shape/outline.hpp"

namespace inkcell::gen {

/// A place on an outline: a segment, numbered through all contours, and eighths
/// of its parameter.
struct MorphStop {
  int segment = 0;
  int eighth = 0;  // 0..7
};

/// What a side of a piece does.
enum class MorphMove {
  to_end,    // to the end of the segment
  stay,      // nothing
  to_stop,   // to `eighth` of the segment
  jump,      // along a line to `target`
  fraction,  // along a slit, to `eighth` of it
};

/// A line or a quadratic curve of one glyph, and how it is reached.
struct MorphSide {
  MorphMove move = MorphMove::stay;
  int eighth = 0;
  MorphStop target;
  Point p[3];  // [u]
};

/// A piece of a contour: it travels from `side[0]` to `side[1]`.
struct MorphPiece {
  MorphSide side[2];
  int stop[2] = {0, 0};  // where it begins in the match
};

/// A closed contour on its way. Where a glyph has no such contour, the contour
/// lies there on a slit: the line between the middles of two chords.
struct MorphContour {
  int missing = -1;    // the glyph that lacks it; -1: none
  MorphStop start[2];  // where the pieces begin
  MorphStop slit[4];   // the ends of two chords, of the glyph that lacks it
  Point slit_middle;   // [u]
  std::vector<MorphPiece> pieces;
};

struct MorphPair {
  std::vector<MorphContour> contours;  // none: both glyphs are blank
};

/// A slit lengthens in the first quarter of the time. `progress`: from the
/// glyph that lacks the contour.
inline double slit_length(double progress) {
  return progress < 0.25 ? 4 * progress : 1;
}

/// The progress of the ends of a cut: one that opens in the first glyph waits
/// for an eighth of the time, one that closes in the second arrives as early.
inline double cut_progress(double progress, bool opens, bool closes) {
  const double begin = opens ? 0.125 : 0;
  const double end = closes ? 0.875 : 1;
  return std::clamp((progress - begin) / (end - begin), 0.0, 1.0);
}

}  // namespace inkcell::gen
