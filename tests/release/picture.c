// The picture of picture.cpp in C.
#include <stdio.h>

#include "inkcell.h"
#include "sans.h"

#define WIDTH 200
#define HEIGHT 40

int main(void) {
  static uint8_t pixels[WIDTH * HEIGHT];
  inkcell_font_t font;
  inkcell_style_t style;
  inkcell_sink_t sink;
  inkcell_grey8_target_t target = {.strip = {pixels, sizeof pixels, 0, 0, WIDTH,
                                             HEIGHT, WIDTH, INKCELL_LOW_FIRST},
                                   .level = 255};
  if (inkcell_font_open(sans, sans_size, &font) != INKCELL_OK ||
      inkcell_style_make(INKCELL_Q6(24), &inkcell_filter_area, &style) !=
          INKCELL_OK ||
      inkcell_grey8_sink(&target, &sink) != INKCELL_OK) {
    return 1;
  }
  const inkcell_painter_t painter = {.sink = &sink};
  inkcell_draw_text(&painter, &font, "Hello, 12:34", INKCELL_TERMINATED, &style,
                    INKCELL_Q6(4), INKCELL_Q6(28));
  printf("P5 %d %d 255\n", WIDTH, HEIGHT);
  return fwrite(pixels, 1, sizeof pixels, stdout) == sizeof pixels ? 0 : 1;
}
