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
  to_end,   // to the end of the segment
  stay,     // nothing
  to_stop,  // to `eighth` of the segment
  jump,     // along a line to `target`
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

/// The time in which a contour is born, and the unit of its beginning.
inline constexpr int kBirths = 16;  // of the whole time
inline constexpr int kSwells = 4;   // of its size

/// A closed contour on its way. Where a glyph has no such contour, all of its
/// pieces lie at a point there: the middle of a chord.
struct MorphContour {
  int missing = -1;    // the glyph that lacks it; -1: none
  MorphStop start[2];  // where the pieces begin
  MorphStop chord[2];  // of the glyph that lacks it
  int birth = 0;       // before it, the contour does not show [1/kBirths]
  int swell = 0;       // how much larger it is half-way, so that the area of
                       // the ink stays [1/kSwells]
  std::vector<MorphPiece> pieces;
};

struct MorphPair {
  std::vector<MorphContour> contours;  // none: both glyphs are blank
};

/// How large a contour is that is born, beside one that travels evenly: it
/// grows about the middle of the box of its joints.
inline double born_size(const MorphContour& contour, double progress) {
  if (contour.missing < 0) {
    return 1;
  }
  const double since = contour.missing == 0 ? progress : 1 - progress;
  return std::clamp(kBirths * since - contour.birth, 0.0, 1.0) *
         (1 + 4 * since * (1 - since) * contour.swell / kSwells);
}

/// The progress of the ends of a cut: one that opens in the first glyph waits
/// for an eighth of the time, one that closes in the second arrives as early.
inline double cut_progress(double progress, bool opens, bool closes) {
  const double begin = opens ? 0.125 : 0;
  const double end = closes ? 0.875 : 1;
  return std::clamp((progress - begin) / (end - begin), 0.0, 1.0);
}

}  // namespace inkcell::gen
