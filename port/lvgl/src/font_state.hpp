// The state in an inkcell_lv_font_t beside LVGL's font.
#pragma once

#include "inkcell/cache/glyph_cache.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "inkcell/painter.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"
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

struct FontState {
  Font font;
  Style style{kMinSize, kFilterText};
  Workspace workspace;
  const GlyphCache* cache = nullptr;
  OpenLcd open_lcd = nullptr;  // null: grey
  Lcd lcd;
  bool is_direct = false;

  void draw(uint16_t glyph, Point origin, const Sink& sink) const noexcept {
    Painter(sink, workspace, cache).glyph(font, style, origin, glyph);
  }
};

static_assert(sizeof(FontState) <= sizeof(inkcell_lv_font_t::state),
              "enlarge inkcell_lv_font_t");

inline FontState& state_of(inkcell_lv_font_t& font) noexcept {
  return *reinterpret_cast<FontState*>(font.state);
}

/// Opens a font of a coding. False: it is none, or the size is out of range.
inline bool open_font(const void* rom,
                      size_t rom_bytes,
                      const Coding& coding,
                      int32_t size_q6,
                      Font& out) noexcept {
  return Font::open({static_cast<const uint8_t*>(rom), rom_bytes}, coding,
                    out) == Status::ok &&
         size_q6 >= kMinSize.raw && size_q6 <= kMaxSize.raw;
}

/// Makes LVGL's font of a state whose font is open, and whose style is set.
void begin_font(const FontState& state, inkcell_lv_font_t& font) noexcept;

/// The state of one of our fonts; null for other fonts.
const FontState* state_of(const lv_font_t* font) noexcept;

}  // namespace inkcell::port
