// Draws what draw.py draws, by the interface for C. Arguments: font, picture.
#include <inkcell/inkcell.h>
#include <stdio.h>
#include <string.h>

static uint8_t rom[65536], pixels[120 * 40 * 2];
static inkcell_font_t font;
static inkcell_style_t style;
static inkcell_fit_t fit;
static FILE* out;

static void draw(const inkcell_sink_t* sink, size_t bytes) {
  const inkcell_painter_t painter = {.sink = sink};
  inkcell_draw_text(&painter, &font,
                    "21.5 \xC2\xB0"
                    "C",
                    INKCELL_TERMINATED, &style, INKCELL_Q6(4), INKCELL_Q6(30));
  fwrite(pixels, 1, bytes, out);
  memset(pixels, 0, sizeof pixels);
}

static void fit_for(bool is_mono) {
  inkcell_style_make(INKCELL_Q6(24), &inkcell_filter_area, &style);
  inkcell_fit_make(&font, &style, is_mono, is_mono ? 2 : 0, 256, &fit);
  inkcell_style_set_fit(&style, &fit);
}

static inkcell_strip_t strip_of(int32_t stride) {
  const inkcell_strip_t strip = {pixels, sizeof pixels, 0, 0, 120,
                                 40,     stride,        0};
  return strip;
}

int main(int argc, char** argv) {
  FILE* const file = argc == 3 ? fopen(argv[1], "rb") : NULL;
  out = argc == 3 ? fopen(argv[2], "wb") : NULL;
  if (file == NULL || out == NULL ||
      inkcell_font_open(rom, fread(rom, 1, sizeof rom, file), &font) != 0) {
    return 1;
  }
  inkcell_sink_t sink;
  inkcell_mono_pages_target_t pages = {strip_of(120), 128, 1};
  inkcell_rgb565_target_t rgb565 = {strip_of(240), 0xFFE0};
  inkcell_grey4_target_t grey4 = {strip_of(60), 15, INKCELL_HIGH_LEFT};
  inkcell_mono_rows_target_t rows = {strip_of(15), 128, 1, INKCELL_HIGH_LEFT};
  inkcell_grey2_target_t grey2 = {strip_of(30), 3, INKCELL_LOW_LEFT};
  inkcell_grey8_target_t grey8 = {strip_of(120), 255};
  fit_for(true);
  inkcell_mono_pages_sink(&pages, &sink);
  draw(&sink, 120 * 5);
  fit_for(false);
  inkcell_rgb565_sink(&rgb565, &sink);
  draw(&sink, 120 * 40 * 2);
  inkcell_grey4_sink(&grey4, &sink);
  draw(&sink, 60 * 40);
  fit_for(true);
  inkcell_mono_rows_sink(&rows, &sink);
  draw(&sink, 15 * 40);
  fit_for(false);
  inkcell_grey2_sink(&grey2, &sink);
  draw(&sink, 30 * 40);
  inkcell_grey8_sink(&grey8, &sink);
  draw(&sink, 120 * 40);
  fclose(out);
  return 0;
}
