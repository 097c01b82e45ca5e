// The state in an inkcell_lv_font_t beside LVGL's font.
#pragma once

#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/canvas_colour.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/font.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "inkcell/painter.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell::port {

/// Memory for one canvas.
union LcdCanvas {
  Rgb565Canvas rgb565;
  Rgb888Canvas rgb888;
  Xrgb8888Canvas xrgb8888;

  LcdCanvas() noexcept : rgb565() {}
};

/// Set by an optional function, so that the linker can drop unused ones.
using OpenLcd = const Sink* (*)(const lv_layer_t& layer,
                                lv_color_t colour,
                                LcdCanvas& canvas);

/// The same: a filter whose edges lie `width_px` further out.
using MakeOutline = void (*)(const Filter& edge, int32_t width_px, Filter& out);

/// The same: draws a glyph in colours, by a painter of a sink of that ink.
using DrawColours = void (*)(const Painter& painter,
                             const CanvasColour& ink,
                             const Font& font,
                             const Style& style,
                             Point origin,
                             uint16_t glyph);

struct FontState {
  Font font;
  Style style{kMinSize, kFilterText};
  Workspace workspace;
  const GlyphCache* cache = nullptr;
  OpenLcd open_lcd = nullptr;          // null: grey
  MakeOutline make_outline = nullptr;  // null: styles' strokes are not drawn
  DrawColours draw_colours = nullptr;  // null: glyphs have one colour
  Lcd lcd;
  bool is_direct = false;
  bool has_weight = false;
  mutable bool has_warned = false;  // once for a font
};

/// The same style with another filter.
inline Style with_filter(const Style& style, const Filter& filter) noexcept {
  Style result(style.size(), filter);
  if (style.is_fitted()) {
    result.set_fit(*style.fitter(), style.fit_options());
  }
  if (style.effect() != nullptr) {
    result.set_effect(*style.effect());
  }
  return result;
}

static_assert(sizeof(FontState) <= sizeof(inkcell_lv_font_t::state),
              "enlarge inkcell_lv_font_t");

inline FontState& state_of(inkcell_lv_font_t& font) noexcept {
  return *reinterpret_cast<FontState*>(font.state);
}

/// The result of a call of LVGL's kind; LVGL logs why it is refused.
lv_result_t result_of(const char* call, Status status) noexcept;

/// Opens a font of a coding. bad_argument: the size is out of range.
inline Status open_font(const void* rom,
                        size_t rom_bytes,
                        const Coding& coding,
                        int32_t size_q6,
                        Font& out) noexcept {
  return size_q6 < kMinSize.raw || size_q6 > kMaxSize.raw
             ? Status::bad_argument
             : Font::open({static_cast<const uint8_t*>(rom), rom_bytes}, coding,
                          out);
}

/// Makes LVGL's font of a state whose font is open, and whose style is set.
void begin_font(const FontState& state, inkcell_lv_font_t& font) noexcept;

/// The state of one of our fonts; null for other fonts.
const FontState* state_of(const lv_font_t* font) noexcept;

}  // namespace inkcell::port
