// The hints of outline fonts, read from docs/FORMAT.md alone.
#pragma once

#include <cstdint>
#include <vector>

#include "inkcell/font.hpp"

namespace inkcell::tools {

/// A height that edges of many glyphs share. [u]
struct HintZone {
  int flat_u = 0;
  int overshoot_u = 0;  // of round edges
  bool is_top = false;  // ink is below it
};

/// A hint about heights: a bar or serif from `low_u` to `high_u`, or an edge or
/// a free end at `low_u`.
struct HeightHint {
  enum class Kind : uint8_t { bar, serif, edge, free_end };

  Kind kind = Kind::bar;
  int low_u = 0;
  int high_u = 0;
  int zone = -1;       // of one of its edges
  bool rises = false;  // of a free end
};

/// A vertical stem.
struct StemHint {
  int left_u = 0;
  int right_u = 0;
};

struct GlyphHints {
  bool is_symmetric = false;
  int left_inset_u = 0;  // from the box to the ink without serifs
  int right_inset_u = 0;
  std::vector<HeightHint> heights;
  std::vector<StemHint> stems;
};

/// Section GRID, and the hints of glyphs.
struct GridHints {
  bool is_there = false;
  bool has_contrast = false;
  bool has_few_bars = false;
  int stem_width_u = 0;
  int bar_width_u = 0;
  int x_zone = -1;
  std::vector<HintZone> zones;
  std::vector<GlyphHints> glyphs;  // of every glyph if the section is there
};

/// Reads any bytes; ignores what is outside of the section.
GridHints grid_hints(const Font& font);

const char* kind_name(HeightHint::Kind kind);

}  // namespace inkcell::tools
