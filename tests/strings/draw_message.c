#include "draw_message.h"

#include "inkcell/c/shaping.h"
#include "inkcell/c/text_box.h"

void draw_message(const inkcell_font_t* font,
                  const inkcell_style_t* style,
                  const inkcell_sink_t* sink,
                  const char* text) {
  static inkcell_text_glyph_t room[64];
  static uint16_t cells[256];
  inkcell_bidi_t bidi;
  inkcell_bidi_init(&bidi, cells, 256);
  inkcell_text_shaper_t shaper;
  inkcell_text_shaper_init(room, 64, &shaper);
  inkcell_line_shaper_t lines;
  inkcell_line_shaper_init(&shaper, &bidi, &lines);
  const inkcell_painter_t painter = {.sink = sink, .lines = &lines};
  inkcell_draw_text(&painter, font, text, INKCELL_TERMINATED, style,
                    INKCELL_Q6(20), INKCELL_Q6(60));

  const inkcell_rect_t rect = {20, 80, 220, 180};
  inkcell_text_box_t box;
  inkcell_text_box_init(&box, font, style, &rect);
  inkcell_layout_options_set_bidi(&box.options, &bidi);
  inkcell_layout_options_set_shaper(&box.options, &shaper);
  inkcell_text_box_draw(&box, &painter, text, INKCELL_TERMINATED, NULL, 0);
}
