// A label for a display of 1 bit in pages, as SSD1306 takes them.
#include "examples.h"

inkcell_status_t draw_label(const void* rom,
                            size_t rom_size,
                            const char* text,
                            uint8_t pages[LABEL_WIDTH * LABEL_HEIGHT / 8]) {
  inkcell_font_t font;
  inkcell_status_t status = inkcell_font_open(rom, rom_size, &font);
  if (status != INKCELL_OK) {
    return status;
  }
  inkcell_style_t style;
  status = inkcell_style_make(INKCELL_Q6(12), &inkcell_filter_text, &style);
  if (status != INKCELL_OK) {
    return status;
  }

  inkcell_mono_pages_target_t target = {
      .strip = {pages, LABEL_WIDTH * LABEL_HEIGHT / 8, 0, 0, LABEL_WIDTH,
                LABEL_HEIGHT,
                INKCELL_STRIDE_BYTES(INKCELL_MONO_PAGES, LABEL_WIDTH),
                INKCELL_LOW_FIRST},
      .threshold = 128,
      .level = 1};
  inkcell_sink_t sink;
  status = inkcell_mono_pages_sink(&target, &sink);
  if (status != INKCELL_OK) {
    return status;
  }

  const inkcell_painter_t painter = {.sink = &sink};
  inkcell_pixel_measure_t measure;
  inkcell_measure(&painter, &font, text, INKCELL_TERMINATED, &style, &measure);
  inkcell_draw_text(&painter, &font, text, INKCELL_TERMINATED, &style,
                    (INKCELL_Q6(LABEL_WIDTH) - measure.advance_q6) / 2,
                    INKCELL_Q6(12));
  return INKCELL_OK;
}
