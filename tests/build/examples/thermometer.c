// A thermometer on SSD1306 whose fonts have strikes alone: digits of 40 px, a
// label of 10 px and an icon.
#include <fonts/thermometer_digits.h>
#include <fonts/thermometer_label.h>
#include <inkcell/inkcell.h>
#include <string.h>

#include "your_board.h"

#define WIDTH 128
#define TRY INKCELL_RETURN_ON_ERROR

static uint8_t pixels[WIDTH * 64 / 8];

static void write_tenths(int32_t tenths, char text[4]) {
  text[0] = (char)('0' + tenths / 100 % 10);
  text[1] = (char)('0' + tenths / 10 % 10);
  text[2] = '.';
  text[3] = (char)('0' + tenths % 10);
}

static inkcell_status_t run(void) {
  inkcell_i2c_display_t i2c = {.write = write_i2c, .address = 0x3c};
  inkcell_ssd1306_t display = {.width = WIDTH, .height = 64};
  inkcell_i2c_bus(&i2c, &display.bus);
  TRY(inkcell_ssd1306_init(&display));

  inkcell_font_t digits, label;
  inkcell_style_t large, small;
  TRY(inkcell_font_open_bit_strike(thermometer_digits, thermometer_digits_size,
                                   &digits));
  TRY(inkcell_font_open_bit_strike(thermometer_label, thermometer_label_size,
                                   &label));
  TRY(inkcell_style_make(INKCELL_Q6(40), &inkcell_filter_area, &large));
  TRY(inkcell_style_make(INKCELL_Q6(10), &inkcell_filter_area, &small));

  inkcell_mono_pages_target_t screen = {
      {pixels, sizeof pixels, 0, 0, WIDTH, 64, WIDTH, 0}, 128, 1};
  inkcell_sink_t sink;
  TRY(inkcell_mono_pages_sink(&screen, &sink));
  const inkcell_painter_t painter = {.sink = &sink};
  for (int32_t tenths = 215;; tenths = (tenths + 1) % 1000) {
    char text[4];
    write_tenths(tenths, text);
    memset(pixels, 0, sizeof pixels);
    inkcell_draw_text(&painter, &label, "Living room \xee\x80\x81",
                      INKCELL_TERMINATED, &small, INKCELL_Q6(2),
                      INKCELL_Q6(12));
    inkcell_draw_text(&painter, &digits, text, 4, &large, INKCELL_Q6(2),
                      INKCELL_Q6(56));
    TRY(inkcell_ssd1306_write(&display, &screen.strip));
    wait_ms(NULL, 1000);
  }
}

int main(void) {
  return run();  // returns if something is wrong
}
