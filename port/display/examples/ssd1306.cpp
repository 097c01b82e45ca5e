// An OLED of 128 x 64 px, SSD1306 on I2C, 1 bit: a paragraph in the upper six
// pages, and a line that scrolls below. Text is fitted to the grid of pixels.
//
// Coming from U8g2:
//
//   U8G2_SSD1306_128X64_NONAME_F_HW_I2C  Ssd1306; write_i2c() is yours
//   u8g2.begin()                         init(display)
//   u8g2.clearBuffer()                   MonoPagesCanvas canvas(strip, 1, 0)
//   u8g2.setDrawColor(0)                 canvas.set_level(0)
//   u8g2.setFont(u8g2_font_helvR10_tf)   Style(12_px) with a Fit
//   u8g2.drawUTF8(x, y, "A")             painter.text(font, style, {x, y}, "A")
//   u8g2.getUTF8Width("A")               Painter::measure(font, style, "A")
//   u8g2.sendBuffer()                    write(display, screen)
//   u8g2.updateDisplayArea(0, 6, 16, 2)  write(display, line)
//   firstPage() ... nextPage()           run_strips() with rows_per_stride = 8
//   lines that you break yourself        TextBox
//   drawUTF8(-scroll, y, title)          ScrollingLabel, which draws only the
//                                        glyphs in its window
#include <fonts/oled.hpp>
#include <inkcell/fit.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/layout/label.hpp>
#include <inkcell/layout/text_box.hpp>
#include <inkcell/port/i2c_display.hpp>
#include <inkcell/port/ssd1306.hpp>

#include "your_board.h"

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kWidth = 128;
constexpr int32_t kTop = 48;  // of the line that scrolls
constexpr int32_t kGap = 24;  // between its end and its beginning
constexpr const char* kWords =
    "Pump 2 is running dry. Close the valve and call the service.";
constexpr const char* kNews = "Tank A 71 %, tank B 64 %, outside 21.5 C";
static uint8_t pixels[kWidth * 64 / 8];
static PositionedGlyph glyphs[64];  // of the line that scrolls

static Status run() {
  I2cDisplay i2c;  // at address 0x3c
  i2c.write = write_i2c;
  Ssd1306 display;
  display.bus = make_bus(i2c);
  INKCELL_TRY(init(display));

  Font font;
  INKCELL_TRY(Font::open(fonts::oled, font));
  Style style(12_px);
  FitOptions options;
  options.across = true;
  options.levels = 2;
  Fit fit;
  INKCELL_TRY(Fit::make(font, style, options, fit));
  style.set_fit(fit);

  const Strip screen = {pixels, 0, 0, kWidth, 64, kWidth};
  const TextBox box(font, style, {0, 0, kWidth, kTop}, Align::centre);
  box.draw(kWords, MonoPagesCanvas(screen, 1, 0));
  INKCELL_TRY(write(display, screen));

  ScrollingLabel label;
  INKCELL_TRY(ScrollingLabel::make(box.options, kNews, {0, kTop, kWidth, 64},
                                   glyphs, label));
  const int32_t length = label.width().floor() + kGap;
  const Strip line = {
      {pixels + kTop / 8 * kWidth, 2 * kWidth}, 0, kTop, kWidth, 16, kWidth};
  for (int32_t scroll = 0;; scroll = (scroll + 1) % length) {
    label.draw_endless(Q26_6::from_int(scroll), Q26_6::from_int(kGap),
                       MonoPagesCanvas(line, 1, 0));
    INKCELL_TRY(write(display, line));
    wait_ms(nullptr, 30);
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
