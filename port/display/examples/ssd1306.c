// ssd1306.cpp in C99: an OLED of 128 x 64 px on I2C, 1 bit; a paragraph in the
// upper six pages, and a line that scrolls below, fitted to the grid of pixels.
//
// Coming from U8g2:
//
//   u8g2_Setup_ssd1306_i2c_...(...)  inkcell_ssd1306_t; write_i2c() is yours
//   u8g2_InitDisplay(&u8g2)          inkcell_ssd1306_init(&display)
//   u8g2_SetFont(&u8g2, font)        inkcell_style_make(), ..._fit_levels()
//   u8g2_DrawUTF8(&u8g2, x, y, "A")  inkcell_draw_text(), x and y in 1/64 px
//   u8g2_SendBuffer(&u8g2)           inkcell_ssd1306_write(&display, &screen)
#include <fonts/oled_c.h>
#include <inkcell/inkcell.h>
#include <string.h>

#include "your_board.h"

#define WIDTH 128
#define TOP 48  // of the line that scrolls
#define GAP 24  // between its end and its beginning
#define TRY INKCELL_RETURN_ON_ERROR

static uint8_t pixels[WIDTH * 64 / 8];
static inkcell_positioned_glyph_t glyphs[64];  // of the line that scrolls

static inkcell_status_t run(void) {
  inkcell_i2c_display_t i2c = {.write = write_i2c, .address = 0x3c};
  inkcell_ssd1306_t display = {.width = WIDTH, .height = 64};
  inkcell_i2c_bus(&i2c, &display.bus);
  TRY(inkcell_ssd1306_init(&display));

  inkcell_font_t font;
  inkcell_style_t style;
  TRY(inkcell_font_open(oled_c, oled_c_size, &font));
  TRY(inkcell_style_make(INKCELL_Q6(12), &inkcell_filter_area, &style));
  inkcell_style_fit_levels(&style, 2);

  inkcell_mono_pages_target_t screen = {
      {pixels, sizeof pixels, 0, 0, WIDTH, 64, WIDTH, 0}, 128, 1};
  inkcell_sink_t sink;
  TRY(inkcell_mono_pages_sink(&screen, &sink));
  const inkcell_rect_t upper = {0, 0, WIDTH, TOP};
  inkcell_text_box_t box;
  inkcell_text_box_init(&box, &font, &style, &upper);
  box.options.align = INKCELL_ALIGN_CENTRE;
  const inkcell_painter_t painter = {.sink = &sink};
  inkcell_text_box_draw(
      &box, &painter,
      "Pump 2 is running dry. Close the valve and call the service.",
      INKCELL_TERMINATED, NULL, 0);
  TRY(inkcell_ssd1306_write(&display, &screen.strip));

  const inkcell_rect_t lower = {0, TOP, WIDTH, 64};
  inkcell_scrolling_label_t label;
  TRY(inkcell_scrolling_label_make(
      &box.options, &painter, "Tank A 71 %, tank B 64 %, outside 21.5 C",
      INKCELL_TERMINATED, &lower, glyphs, 64, &label));
  const int32_t length = inkcell_scrolling_label_width(&label) / 64 + GAP;
  uint8_t* const rows = pixels + TOP / 8 * WIDTH;
  inkcell_mono_pages_target_t line = {
      {rows, 2 * WIDTH, 0, TOP, WIDTH, 16, WIDTH, 0}, 128, 1};
  TRY(inkcell_mono_pages_sink(&line, &sink));
  for (int32_t scroll = 0;; scroll = (scroll + 1) % length) {
    memset(rows, 0, 2 * WIDTH);
    inkcell_scrolling_label_draw_endless(&label, &painter, INKCELL_Q6(scroll),
                                         INKCELL_Q6(GAP));
    TRY(inkcell_ssd1306_write(&display, &line.strip));
    wait_ms(NULL, 30);
  }
}

int main(void) {
  return run();  // returns if something is wrong
}
