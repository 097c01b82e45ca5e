#include "draw_greeting.h"

#include <fonts/ui_c.h>

void draw_greeting(const inkcell_font_t* font,
                   const inkcell_style_t* style,
                   const inkcell_sink_t* sink) {
  const inkcell_painter_t painter = {.sink = sink};
  inkcell_draw_shaped(&painter, font, &ui_c_strings_greeting, style,
                      INKCELL_Q6(4), INKCELL_Q6(28));
}

inkcell_status_t open_greeting_font(inkcell_font_t* out) {
  return inkcell_font_open(ui_c, ui_c_size, out);
}

inkcell_status_t measure_greeting(const inkcell_font_t* font,
                                  const inkcell_style_t* style,
                                  inkcell_positioned_glyph_t* out,
                                  size_t capacity,
                                  size_t* count,
                                  inkcell_pixel_measure_t* measure) {
  inkcell_measure_shaped(NULL, font, &ui_c_strings_greeting, style, measure);
  return inkcell_lay_out_shaped(NULL, font, &ui_c_strings_greeting, style, out,
                                capacity, count);
}
