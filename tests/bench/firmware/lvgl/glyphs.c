// LVGL's bitmap fonts as an engine: what a label asks a font for, a glyph's
// metrics and its bitmap in 8 bits. Ways: "raw" and "rle", as lv_font_conv
// packs the pixels.
#include <string.h>

#include "engine.h"
#include "heap.h"
#include "lv_fonts.h"

static uint8_t pixels[kEngineSide * kEngineSide];
static const lv_font_t* font;
static lv_font_glyph_dsc_t glyph;
static lv_draw_buf_t buffer;
static size_t own_heap;  // of LVGL before it draws

bool engine_open(const uint8_t* bytes, size_t size) {
  (void)bytes;
  (void)size;
  lv_init();
  return true;
}

bool engine_set_size(uint32_t px, const char* way) {
  font = NULL;
  for (size_t i = 0; i != sizeof lv_fonts / sizeof *lv_fonts; ++i) {
    if (lv_fonts[i].px == px && strcmp(lv_fonts[i].way, way) == 0) {
      font = lv_fonts[i].font;
    }
  }
  heap_forget();
  own_heap = heap_most();
  return font != NULL;
}

enum engine_answer engine_prepare(uint32_t code_point) {
  if (!lv_font_get_glyph_dsc(font, &glyph, code_point, 0)) {
    return engine_lacks;
  }
  if (glyph.box_w > kEngineSide || glyph.box_h > kEngineSide) {
    return engine_too_large;
  }
  // A pixel at least, where there is no ink.
  const uint32_t width = glyph.box_w == 0 ? 1 : glyph.box_w;
  const uint32_t rows = glyph.box_h == 0 ? 1 : glyph.box_h;
  return lv_draw_buf_init(&buffer, width, rows, LV_COLOR_FORMAT_A8,
                          LV_STRIDE_AUTO, pixels, sizeof pixels) == LV_RESULT_OK
             ? engine_ready
             : engine_too_large;
}

void engine_draw(uint32_t code_point) {
  lv_font_get_glyph_dsc(font, &glyph, code_point, 0);
  lv_font_get_glyph_bitmap(&glyph, &buffer);
}

uint32_t engine_ink(void) {
  uint32_t sum = 0;
  for (uint32_t i = 0; i != engine_box(); ++i) {
    sum += pixels[i / glyph.box_w * buffer.header.stride + i % glyph.box_w];
  }
  return sum;
}

uint32_t engine_box(void) {
  return (uint32_t)glyph.box_w * glyph.box_h;
}

size_t engine_heap(void) {
  return heap_most() - own_heap;
}

size_t engine_workspace(void) {
  return 0;
}
