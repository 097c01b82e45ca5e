// What is found out about a glyph of outlines before its points are read.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/glyph_warp.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"
#include "outlines/outline_glyph.hpp"
#include "place/position.hpp"
#include "rows/outline_mixer.hpp"

namespace inkcell {
namespace detail {

// A glyph to draw, and where.
struct OutlineJob {
  const Font& font;
  Span<const uint8_t> record;
  const TextStyle& style;
  const Placed& placed;
  uint16_t glyph;
};

struct Opening {
  OutlineGlyph& glyph;
  OutlinePlan& plan;
  const GlyphWarp*& warp;  // null, or `fitted`
  GlyphWarp* fitted;       // room for the maps of a glyph
};

// How glyphs are moved to the grid of pixels.
struct OutlineFitter {
  bool (*open)(const Opening& opening,
               const OutlineJob& job,
               const GlyphMetrics& metrics) noexcept;
  // Moves points of a glyph.
  void (*apply)(const GlyphWarp& warp,
                const OutlineGlyph& glyph,
                const OutlinePlan& plan,
                ScreenPoint* points,
                const ScreenPoint* end) noexcept;
};

// False if there is nothing to draw, or the style was not made.
bool open_outline(const Opening& opening, const OutlineJob& job) noexcept;

// The pixels that draw_outline() may touch.
Rect outline_box(const Font& font,
                 uint16_t glyph,
                 Span<const uint8_t> record,
                 const TextStyle& style,
                 const Placed& placed) noexcept;

}  // namespace detail
}  // namespace inkcell
