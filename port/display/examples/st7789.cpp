// A colour panel of 240 x 240 px, ST7789 on SPI: a label with an icon and
// Chinese characters, and a temperature. While one strip is sent by DMA, the
// next is drawn. When the temperature changes, its box alone is drawn and sent.
//
// Coming from Adafruit_GFX and Adafruit_ST7789:
//
//   Adafruit_ST7789 tft(cs, dc, rst)     St7789, and the functions of yours
//   tft.init(240, 240)                   init(display)
//   tft.setRotation(1)                   display.rotation = Rotation::quarter
//   tft.color565(r, g, b)                rgb565(r, g, b)
//   tft.setFont(&FreeSans18pt7b)         Style(24_px): any size of one font
//   tft.setTextColor(ink)                Rgb565Canvas canvas(strip, ink, paper)
//   tft.setCursor(x, y); tft.print("A")  painter.text(font, style, {x, y}, "A")
//   tft.getTextBounds("A", x, y, ...)    painter.box(font, style, {x, y}, "A")
//   tft.fillRect(...); tft.print(value)  run_strips(loop, label.set(value, {}))
//
// There, after setFont(), as here y is that of the baseline. Text is UTF-8.
#include <fonts/room.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/port/display_loop.hpp>
#include <inkcell/port/st7789.hpp>

#include "your_board.h"

using namespace inkcell;
using namespace inkcell::port;

constexpr uint16_t kInk = rgb565(255, 255, 255);
constexpr uint16_t kPaper = rgb565(0, 50, 90);
constexpr Style kLabel = Style(24_px);
constexpr Style kValue = Style(80_px);
constexpr int32_t kRows = 8;  // of a strip
alignas(4) static uint8_t strips[2][2 * 240 * kRows];

struct Screen {
  const Font& font;
  ValueLabel value;
};

static Status draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  const Rgb565Canvas canvas(strip, kInk, kPaper);
  Painter(canvas).text(screen.font, kLabel, {16, 48},
                       u8"\uE001 Living \u5BA2\u5385");
  screen.value.draw(canvas);
  return canvas.status();
}

static Status run() {
  St7789 display;
  display.bus.command = write_command;
  display.bus.data = write_data;
  display.bus.start = start_data;
  display.bus.wait_sent = wait_sent;
  display.bus.reset = pulse_reset;
  display.bus.wait_ms = wait_ms;
  display.width = display.height = 240;
  display.inverted = true;  // as on most of these panels
  INKCELL_TRY(init(display));
  Font font;
  INKCELL_TRY(Font::open(fonts::room, font));
  Screen screen = {font, ValueLabel(font, kValue, {16, 150})};
  StripLoop loop = loop_over(display, strips[0], strips[1]);
  loop.context = &screen;
  loop.draw = draw;
  screen.value.set(read_temperature(), {});
  INKCELL_TRY(run_strips(loop));
  for (;;) {
    wait_ms(nullptr, 1000);
    const Rect changed = screen.value.set(read_temperature(), {});
    INKCELL_TRY(run_strips(loop, changed));
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
