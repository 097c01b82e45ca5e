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

// A glyph that is open.
struct OpenGlyph {
  OutlinePlan plan;
  // Before it is opened room for its maps; null then if it is not fitted.
  GlyphWarp* warp;
  OutlineGlyph glyph;
};

// How glyphs are moved to the grid of pixels.
struct OutlineFitter {
  // open_outline() of a glyph whose plan is made.
  bool (*open)(OpenGlyph& opened, const OutlineJob& job) noexcept;
  // Moves points of the glyph.
  void (*apply)(const OpenGlyph& opened,
                ScreenPoint* points,
                const ScreenPoint* end) noexcept;
};

// False if there is nothing to draw, or the style was not made.
bool open_outline(OpenGlyph& opened, const OutlineJob& job) noexcept;

// The pixels that draw_outline() may touch.
Rect outline_box(const Font& font,
                 uint16_t glyph,
                 Span<const uint8_t> record,
                 const TextStyle& style,
                 const Placed& placed) noexcept;

}  // namespace detail
}  // namespace inkcell
