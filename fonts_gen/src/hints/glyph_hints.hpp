// The hints of one glyph, as in its record.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "hints/face.hpp"
#include "hints/features.hpp"

namespace inkcell::gen {

/// An edge at the height of a zone, or at an even position. [u]
struct EdgeHint {
  std::optional<ZoneEdge> zone;
  int position_u = 0;
};

struct HeightHint {
  enum class Kind { bar, serif, lone_edge, free_end };

  Kind kind = Kind::bar;
  EdgeHint edge;
  bool is_top_edge = false;    // of a bar or serif: the edge that is stored
  std::optional<int> width_u;  // of a bar or serif; none: the face's bar width
  bool rises = false;          // of a free end
};

/// A vertical stem.
struct StemHint {
  int position_u = 0;          // the left edge
  std::optional<int> width_u;  // none: the face's stem width
};

struct GlyphHints {
  bool is_symmetric = false;
  int left_inset_u = 0;  // from the box to the ink without serifs
  int right_inset_u = 0;
  std::vector<HeightHint> heights;  // ascending by their lower edges
  std::vector<StemHint> stems;      // from left to right

  bool empty() const {
    return !is_symmetric && left_inset_u == 0 && right_inset_u == 0 &&
           heights.empty() && stems.empty();
  }
};

/// The hints of a font.
struct FontHints {
  FaceHints face;
  std::vector<GlyphHints> glyphs;  // none: the font has no section GRID

  bool empty() const { return glyphs.empty(); }
};

/// Chooses hints from features. `box` is the one in METR, left and right [u].
/// Drops positions beyond the range of the format, and the least important
/// hints if there are too many for the knots of a map.
GlyphHints make_glyph_hints(const GlyphFeatures& features,
                            const FaceHints& face,
                            const Interval& box);

/// The height of an edge. [u]
int height_of(const EdgeHint& edge, const FaceHints& face);

/// [bottom, top] of a bar or serif.
std::array<int, 2> edges_of(const HeightHint& bar, const FaceHints& face);

}  // namespace inkcell::gen
