// An OLED of 128 x 64 px, SSD1306 on I2C, 1 bit: a paragraph in the upper six
// pages, and a line that scrolls below. Text is fitted to the grid of pixels.
//
// Coming from U8g2:
//
//   U8G2_SSD1306_128X64_NONAME_F_HW_I2C  Ssd1306; write_i2c() is yours
//   u8g2.begin()                         init(display)
//   u8g2.clearBuffer()                   MonoPagesCanvas canvas(strip, 1, 0)
//   u8g2.setDrawColor(0)                 canvas.set_level(0)
//   u8g2.setFont(u8g2_font_helvR10_tf)   MonoPagesCanvas::style(12_px)
//   u8g2.drawUTF8(x, y, "A")             painter.text(font, style, {x, y}, "A")
//   u8g2.getUTF8Width("A")               painter.measure(font, style, "A")
//   u8g2.sendBuffer()                    run_strips(loop)
//   u8g2.updateDisplayArea(0, 6, 16, 2)  run_strips(loop, {0, 48, 128, 64})
//   firstPage() ... nextPage()           run_strips(): draws two pages a time
//   lines that you break yourself        TextBox
//   drawUTF8(-scroll, y, title)          ScrollingLabel, which draws only the
//                                        glyphs in its window
#include <fonts/oled.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/layout/label.hpp>
#include <inkcell/layout/text_box.hpp>
#include <inkcell/port/display_loop.hpp>
#include <inkcell/port/i2c_display.hpp>
#include <inkcell/port/ssd1306.hpp>

#include "your_board.h"

using namespace inkcell;
using namespace inkcell::port;

constexpr int32_t kWidth = 128;
constexpr int32_t kTop = 48;   // of the line that scrolls
constexpr Q26_6 kGap = 24_px;  // between its end and its beginning
constexpr const char* kWords =
    "Pump 2 is running dry. Close the valve and call the service.";
constexpr const char* kNews = "Tank A 71 %, tank B 64 %, outside 21.5 C";
static uint8_t rows[kWidth * 16 / 8];  // two of the eight pages
static PositionedGlyph glyphs[64];     // of the line that scrolls

struct Screen {
  TextBox words;
  ScrollingLabel news;
  Q26_6 scroll;
};

static Status draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  const MonoPagesCanvas canvas(strip, 1, 0);
  if (strip.y0 < kTop) {
    screen.words.draw(kWords, canvas);
  } else {
    screen.news.draw_endless(screen.scroll, kGap, canvas);
  }
  return canvas.status();
}

static Status run() {
  I2cDisplay i2c;  // at address 0x3c
  i2c.write = write_i2c;
  Ssd1306 display;
  display.bus = make_bus(i2c);
  INKCELL_TRY(init(display));

  Font font;
  INKCELL_TRY(Font::open(fonts::oled, font));
  const Style style = MonoPagesCanvas::style(12_px);

  Screen screen;
  screen.words = TextBox(font, style, {0, 0, kWidth, kTop}, Align::centre);
  INKCELL_TRY(ScrollingLabel::make(screen.words.options, MonoPagesCanvas(),
                                   kNews, {0, kTop, kWidth, 64}, glyphs,
                                   screen.news));
  StripLoop loop = loop_over(display, rows);
  loop.context = &screen;
  loop.draw = draw;
  INKCELL_TRY(run_strips(loop));
  const int32_t length = screen.news.width().floor() + kGap.floor();
  for (int32_t scroll = 0;; scroll = (scroll + 1) % length) {
    screen.scroll = Q26_6::from_int(scroll);
    INKCELL_TRY(run_strips(loop, {0, kTop, kWidth, 64}));
    wait_ms(nullptr, 30);
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
