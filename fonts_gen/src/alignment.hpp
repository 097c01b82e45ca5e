// Where glyphs have edges that want to lie on the grid of pixels.
#pragma once

#include <cstdint>
#include <vector>

#include "font_source.hpp"
#include "shape.hpp"

namespace inkcell::gen {

/// A horizontal piece of a glyph's border, flat or the end of a bend. [u]
struct FlatEdge {
  double y = 0;
  double x0 = 0;
  double x1 = 0;
  bool is_top = false;  // ink is below it
  bool is_flat = false;

  double length() const { return x1 - x0; }
};

/// A stroke between two edges: a horizontal bar, or a vertical stem. [u]
struct Stroke {
  double low = 0;
  double high = 0;
  double length = 0;  // along which both edges face each other
};

/// What grid fitting may want to know of a glyph.
struct GlyphEdges {
  std::vector<FlatEdge> edges;
  std::vector<Stroke> bars;   // do not overlap; ascending
  std::vector<Stroke> stems;  // likewise, from left to right
};

GlyphEdges find_edges(const Shape& shape);

/// A height that edges of many glyphs share.
struct AlignmentLevel {
  int y_u = 0;
  int zone = -1;
};

/// A height that a font's glyphs have in common.
struct AlignmentZone {
  int level = 0;  // that of its flat edges
  bool is_bottom = false;
};

/// An edge of a glyph's list.
struct AlignmentEdge {
  int level = 0;
  bool is_bar = false;  // a bar begins here
};

struct GlyphAlignment {
  std::vector<AlignmentEdge> edges;  // from low to high
  int stem_u = 0;                    // the middle of the left-most one
  int gap_u = 0;
  int stems = 0;  // 0..3, evenly spaced if 3
};

/// All that HINT says.
struct Alignment {
  std::vector<AlignmentLevel> levels;  // ascending
  std::vector<AlignmentZone> zones;
  std::vector<GlyphAlignment> glyphs;
  int stem_width_u = 0;

  bool empty() const { return levels.empty(); }
};

/// Joins what was found in `font`'s glyphs, in their order. Zones are those of
/// Latin type, from the glyphs that show them best, or else from the metrics.
Alignment align(const SourceFont& font, const std::vector<GlyphEdges>& found);

/// HINT, without padding; nothing for an empty alignment.
std::vector<uint8_t> hint_section(const Alignment& alignment);

}  // namespace inkcell::gen
