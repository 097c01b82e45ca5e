// The same as programs in C have them.
#include "canvases.h"
#include "inkcell/c/draw.h"
#include "inkcell/c/pixel.h"

static inkcell_font_t font;
static inkcell_style_t style;
static inkcell_sink_t sink;

static union {
  inkcell_strip_t strip;  // first in all of them
  inkcell_a8_target_t a8;
  inkcell_grey8_target_t grey8;
  inkcell_grey4_target_t grey4;
  inkcell_grey2_target_t grey2;
  inkcell_mono_rows_target_t mono_rows;
  inkcell_mono_pages_target_t mono_pages;
  inkcell_rgb565_target_t rgb565;
  inkcell_rgb888_target_t rgb888;
  inkcell_xrgb8888_target_t xrgb8888;
} target;

static inkcell_status_t open_target(int format) {
  switch (format) {
    case INKCELL_A8:
      return inkcell_a8_sink(&target.a8, &sink);
    case INKCELL_GREY8:
      target.grey8.level = 255;
      return inkcell_grey8_sink(&target.grey8, &sink);
    case INKCELL_GREY4:
      target.grey4.level = 15;
      return inkcell_grey4_sink(&target.grey4, &sink);
    case INKCELL_GREY2:
      target.grey2.level = 3;
      return inkcell_grey2_sink(&target.grey2, &sink);
    case INKCELL_MONO_ROWS:
      target.mono_rows.threshold = 128;
      target.mono_rows.level = 1;
      return inkcell_mono_rows_sink(&target.mono_rows, &sink);
    case INKCELL_MONO_PAGES:
      target.mono_pages.threshold = 128;
      target.mono_pages.level = 1;
      return inkcell_mono_pages_sink(&target.mono_pages, &sink);
    case INKCELL_RGB565:
      target.rgb565.colour = 0xffff;
      return inkcell_rgb565_sink(&target.rgb565, &sink);
    case INKCELL_RGB888:
      target.rgb888.colour = 0xffffff;
      return inkcell_rgb888_sink(&target.rgb888, &sink);
    default:
      target.xrgb8888.colour = 0xffffffff;
      return inkcell_xrgb8888_sink(&target.xrgb8888, &sink);
  }
}

bool canvas_open_font(const uint8_t* bytes, size_t size) {
  return inkcell_font_open(bytes, size, &font) == INKCELL_OK;
}

const char* canvas_set(uint32_t number, uint8_t* pixels) {
  static const char* const names[] = {"a8",     "grey8",     "grey4",
                                      "grey2",  "mono_rows", "mono_pages",
                                      "rgb565", "rgb888",    "xrgb8888"};
  if (number >= sizeof names / sizeof names[0]) {
    return NULL;
  }
  const inkcell_strip_t strip = {
      .pixels = pixels,
      .size = kCanvasWidth * kCanvasHeight * kCanvasMostBytes,
      .width = kCanvasWidth,
      .height = kCanvasHeight,
      .stride = INKCELL_STRIDE_BYTES((int32_t)number, kCanvasWidth)};
  target.strip = strip;
  return open_target((int)number) == INKCELL_OK ? names[number] : NULL;
}

bool canvas_set_size(int32_t px) {
  return inkcell_style_make(INKCELL_Q6(px), &inkcell_filter_area, &style) ==
         INKCELL_OK;
}

void canvas_draw(const char* text, uint8_t* ram, size_t bytes) {
  const inkcell_painter_t painter = {.sink = &sink, .ram = {ram, bytes}};
  inkcell_draw_text(&painter, &font, text, INKCELL_TERMINATED, &style,
                    INKCELL_Q6(4), INKCELL_Q6(96));
}
