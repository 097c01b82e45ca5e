// A sink of a program's own: two functions.
#include "examples.h"

static void take_coverage(void* context,
                          int32_t x,
                          int32_t y,
                          const uint8_t* coverage,
                          int32_t count) {
  uint8_t* pixel = (uint8_t*)context + y * PLOT_WIDTH + x;
  for (int32_t i = 0; i < count; ++i) {
    pixel[i] = coverage[i] > pixel[i] ? coverage[i] : pixel[i];
  }
}

static void take_solid(void* context, int32_t x, int32_t y, int32_t count) {
  uint8_t* pixel = (uint8_t*)context + y * PLOT_WIDTH + x;
  for (int32_t i = 0; i < count; ++i) {
    pixel[i] = 255;
  }
}

inkcell_status_t draw_plot(const void* rom,
                           size_t rom_size,
                           const char* text,
                           uint8_t pixels[PLOT_WIDTH * PLOT_HEIGHT]) {
  inkcell_font_t font;
  inkcell_style_t style;
  inkcell_status_t status = inkcell_font_open(rom, rom_size, &font);
  if (status == INKCELL_OK) {
    // A turn by an eighth of a quarter: cosine and sine of 11.25 degrees.
    status = inkcell_style_make_turned(INKCELL_Q6(16), &inkcell_filter_text,
                                       1053110176, 209476638, &style);
  }
  if (status == INKCELL_OK) {
    const inkcell_sink_t sink = {.window = {0, 0, PLOT_WIDTH, PLOT_HEIGHT},
                                 .context = pixels,
                                 .coverage = take_coverage,
                                 .solid = take_solid};
    const inkcell_painter_t painter = {.sink = &sink};
    inkcell_draw_text(&painter, &font, text, INKCELL_TERMINATED, &style,
                      INKCELL_Q6(2), INKCELL_Q6(20.5));
  }
  return status;
}
