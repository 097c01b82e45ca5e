// The points of outline records, read from docs/FORMAT.md alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "inkcell/font.hpp"

namespace inkcell::tools {

/// As code words number them.
enum class PointKind : uint8_t { off_curve, smooth, corner };

/// A place in a glyph. [font units, y up]
struct OutlinePoint {
  double x = 0;
  double y = 0;
  PointKind kind = PointKind::corner;
};

using OutlineContour = std::vector<OutlinePoint>;

/// A glyph that a composite refers to:
/// x' = xx x + xy y + dx, y' = yx x + yy y + dy. [font units]
struct OutlineComponent {
  uint16_t glyph = 0;
  double xx = 1;
  double xy = 0;
  double yx = 0;
  double yy = 1;
  int dx = 0;
  int dy = 0;
};

/// A glyph's record. The contours of a composite are those of its components,
/// mapped.
struct GlyphOutline {
  std::vector<OutlineContour> contours;
  std::vector<OutlineComponent> components;
  std::vector<int> uses;  // of each entry of code_words(), in this record

  int points() const;
  int points_of(PointKind kind) const;
};

/// A word of the font's code table.
struct CodeWord {
  int table = 0;        // where it stands
  std::string bits;     // such as "0110"; the last may be the first of a number
  bool is_end = false;  // of a contour
  PointKind kind = PointKind::corner;
  int x_bits = 0;  // of dx
  int y_bits = 0;  // of dy
  int next_table = 0;
};

/// The words of section CODE; none if the font has no outlines.
std::vector<CodeWord> code_words(const Font& font);

/// The size of the grid that points lie on. [font units]
double grid_units(const Font& font);

/// Points that any glyph may have, one closing point a contour included.
int max_points(const Font& font);

/// The outline of a glyph; empty if it has none. Reads any bytes.
GlyphOutline glyph_outline(const Font& font, uint16_t glyph);

const char* kind_name(PointKind kind);

}  // namespace inkcell::tools
