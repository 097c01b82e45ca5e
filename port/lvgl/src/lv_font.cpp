// LVGL's font: its metrics, its glyphs, and their A8 bitmaps.
#include "inkcell/fixed.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/status.hpp"

#include "font_state.hpp"

namespace inkcell::port {
namespace {

// What text shows where the font lacks a character that needs no glyph: a space
// of its own width, or nothing. [font units]
int32_t blank_advance(const Font& font, uint32_t letter) noexcept {
  const auto last = [](uint32_t bits) noexcept {
    return static_cast<char>(0x80 | (bits & 0x3f));
  };
  const char utf8[] = {static_cast<char>(0xe0 | letter >> 12),
                       last(letter >> 6), last(letter)};
  const char two[] = {static_cast<char>(0xc0 | letter >> 6), last(letter)};
  const char one[] = {static_cast<char>(letter)};
  return measure(font, letter < 0x80      ? Text{one, 1}
                       : letter < 0x800   ? Text{two, 2}
                       : letter < 0x10000 ? Text{utf8, 3}
                                          : Text{})
      .advance;
}

// LVGL asks fallbacks for the character first, and shows this if they lack it
// too.
void set_blank(const FontState& state,
               uint32_t letter,
               lv_font_glyph_dsc_t& out) noexcept {
  const int32_t units = blank_advance(state.font, letter);
  out.adv_w = static_cast<uint16_t>(
      (to_px(state.font, state.style, units).raw + 32) >> 6);
  out.box_w = 0;
  out.box_h = 0;
  out.format = LV_FONT_GLYPH_FORMAT_NONE;
  out.is_placeholder = true;
}

// [px] Between whole pixels and after kerning, to the nearest.
int32_t advance_px(const FontState& state,
                   uint16_t glyph,
                   uint32_t next_letter) noexcept {
  uint16_t next = 0;
  const int32_t kerning =
      next_letter != 0 && state.font.glyph_of(next_letter, next) == Status::ok
          ? state.font.kerning(glyph, next)
          : 0;
  const Style& style = state.style;
  if (style.has_whole_advances()) {
    return style.fitter()->advance_px(state.font, style, glyph) +
           to_px(state.font, style, kerning).raw / 64;
  }
  const int32_t units = state.font.advance(glyph) + kerning;
  return (to_px(state.font, style, units).raw + 32) >> 6;
}

uint16_t to_uint16(int32_t px) noexcept {
  return static_cast<uint16_t>(px < 0 ? 0 : (px > 65535 ? 65535 : px));
}

bool get_glyph_dsc(const lv_font_t* lv_font,
                   lv_font_glyph_dsc_t* out,
                   uint32_t letter,
                   uint32_t next_letter) noexcept {
  const FontState& state = *state_of(lv_font);
  uint16_t glyph = 0;
  if (state.font.glyph_of(letter, glyph) != Status::ok) {
    if (needs_glyph(letter)) {
      return false;
    }
    set_blank(state, letter, *out);
    return true;
  }
  out->adv_w = to_uint16(advance_px(state, glyph, next_letter));
  Rect box = Painter().glyph_box(state.font, state.style, {}, glyph);
  if (is_empty(box)) {
    box = {};
  }
  out->box_w = to_uint16(box.x1 - box.x0);
  out->box_h = to_uint16(box.y1 - box.y0);
  out->ofs_x = static_cast<int16_t>(box.x0);
  out->ofs_y = static_cast<int16_t>(-box.y1);
  out->stride = 0;
  out->format =
      state.is_direct ? LV_FONT_GLYPH_FORMAT_CUSTOM : LV_FONT_GLYPH_FORMAT_A8;
  out->is_placeholder = false;
  out->gid.index = glyph;
  return true;
}

// Draws the A8 bitmap of a glyph into LVGL's buffer; null if that is too small.
const void* get_glyph_bitmap(lv_font_glyph_dsc_t* glyph,
                             lv_draw_buf_t* buffer) noexcept {
  const FontState& state = *state_of(glyph->resolved_font);
  if (buffer == nullptr) {
    return nullptr;
  }
  Strip strip;
  strip.pixels = {buffer->data, buffer->data_size};
  strip.x0 = glyph->ofs_x;
  strip.y0 = -glyph->ofs_y - glyph->box_h;
  strip.width = glyph->box_w;
  strip.height = glyph->box_h;
  strip.stride = static_cast<int32_t>(buffer->header.stride);
  const A8Canvas canvas(strip);
  if (canvas.status() != Status::ok) {
    return nullptr;
  }
  lv_memzero(buffer->data, static_cast<size_t>(strip.stride) * glyph->box_h);
  Painter(canvas, state.workspace)
      .glyph(state.font, state.style, {},
             static_cast<uint16_t>(glyph->gid.index));
  lv_draw_buf_flush_cache(buffer, nullptr);
  return buffer;
}

// Font units to px, rounded up.
int32_t ceil_px(const FontState& state, int32_t units) noexcept {
  return (to_px(state.font, state.style, units).raw + 63) >> 6;
}

int8_t underline_px(int32_t px_q6) noexcept {
  const int32_t px = (px_q6 + 32) >> 6;
  return static_cast<int8_t>(px < 1 ? 1 : (px > 127 ? 127 : px));
}

void set_metrics(const FontState& state, lv_font_t& out) noexcept {
  const FontMetrics metrics = state.font.metrics();
  const int32_t above = ceil_px(state, metrics.ascender);
  const int32_t gap = ceil_px(state, metrics.line_gap);
  out.base_line = ceil_px(state, -metrics.descender);
  out.line_height = above + out.base_line + gap;
  const int32_t em_q6 = state.style.size().raw;
  out.underline_thickness = underline_px(em_q6 / 20);
  out.underline_position = static_cast<int8_t>(-underline_px(em_q6 / 10));
}

}  // namespace

lv_result_t result_of(const char* call, Status status) noexcept {
  if (status == Status::ok) {
    return LV_RESULT_OK;
  }
  const char* why = "other";
  switch (status) {
    case Status::bad_magic:
      why = "bad_magic: no font of inkcell-fontgen";
      break;
    case Status::bad_version:
      why = "bad_version: make the font anew";
      break;
    case Status::corrupt:
      why = "corrupt: the font is cut short or changed";
      break;
    case Status::buffer_small:
      why = "buffer_small";
      break;
    case Status::misaligned:
      why = "misaligned: align the memory to 4 or a pointer";
      break;
    case Status::unsupported:
      why = "unsupported: another coding, paged, or no such size";
      break;
    case Status::bad_argument:
      why =
          "bad_argument: a count is out of range, or a size: they are in 1/64 "
          "px";
      break;
    default:
      break;
  }
  LV_LOG_ERROR("%s: %s", call, why);
  LV_UNUSED(call);
  LV_UNUSED(why);
  return LV_RESULT_INVALID;
}

const FontState* state_of(const lv_font_t* font) noexcept {
  return font != nullptr && font->get_glyph_dsc == get_glyph_dsc
             ? static_cast<const FontState*>(font->dsc)
             : nullptr;
}

void begin_font(const FontState& state, inkcell_lv_font_t& font) noexcept {
  lv_font_t lv = {};
  lv.get_glyph_dsc = get_glyph_dsc;
  lv.get_glyph_bitmap = get_glyph_bitmap;
  lv.dsc = font.state;
  set_metrics(state, lv);
  font.lv = lv;
  state_of(font) = state;
}

}  // namespace inkcell::port
