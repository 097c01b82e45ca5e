// A paragraph in a box: wrapped, centred, shortened where there is no room.
#include "examples.h"

inkcell_status_t draw_paragraph(
    const void* rom,
    size_t rom_size,
    const char* text,
    uint8_t pixels[PARAGRAPH_WIDTH * PARAGRAPH_HEIGHT]) {
  inkcell_font_t font;
  inkcell_style_t style;
  inkcell_status_t status = inkcell_font_open(rom, rom_size, &font);
  if (status == INKCELL_OK) {
    status = inkcell_style_make(INKCELL_Q6(14), &inkcell_filter_text, &style);
  }
  if (status != INKCELL_OK) {
    return status;
  }

  inkcell_grey8_target_t target = {
      .strip = {pixels, PARAGRAPH_WIDTH * PARAGRAPH_HEIGHT, 0, 0,
                PARAGRAPH_WIDTH, PARAGRAPH_HEIGHT, PARAGRAPH_WIDTH,
                INKCELL_LOW_FIRST},
      .level = 255};
  inkcell_sink_t sink;
  status = inkcell_grey8_sink(&target, &sink);
  if (status != INKCELL_OK) {
    return status;
  }

  const inkcell_rect_t rect = {4, 4, PARAGRAPH_WIDTH - 4, PARAGRAPH_HEIGHT - 4};
  inkcell_text_box_t box;
  inkcell_text_box_init(&box, &font, &style, &rect);
  box.options.align = INKCELL_ALIGN_CENTRE;
  box.options.ellipsis = INKCELL_ELLIPSIS_END;
  box.vertical = INKCELL_VERTICAL_MIDDLE;

  inkcell_text_line_t lines[6];
  size_t count = 0;
  const inkcell_painter_t painter = {.sink = &sink};
  status =
      inkcell_text_box_lay_out(&box, &painter, text, INKCELL_TERMINATED, lines,
                               sizeof lines / sizeof lines[0], &count);
  if (status == INKCELL_OK) {
    inkcell_text_box_draw(&box, &painter, text, INKCELL_TERMINATED, lines,
                          count);
  }
  return status;
}
