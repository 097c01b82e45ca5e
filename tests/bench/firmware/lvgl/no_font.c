// LVGL's default font in programs that name their own.
#include "lvgl.h"

static bool get_no_glyph(const lv_font_t* font,
                         lv_font_glyph_dsc_t* glyph,
                         uint32_t letter,
                         uint32_t next_letter) {
  LV_UNUSED(font);
  LV_UNUSED(glyph);
  LV_UNUSED(letter);
  LV_UNUSED(next_letter);
  return false;
}

const lv_font_t bench_no_font = {.get_glyph_dsc = get_no_glyph,
                                 .line_height = 1};
