// A colour panel of 240 x 240 px, ST7789 on SPI: a label with an icon and
// Chinese characters, and a temperature. While one strip is sent by DMA, the
// next is drawn. When the temperature changes, its box alone is drawn and sent.
//
// Coming from Adafruit_GFX and Adafruit_ST7789:
//
//   Adafruit_ST7789 tft(cs, dc, rst)     St7789, and the functions of yours
//   tft.init(240, 240)                   init(display)
//   tft.setRotation(1)                   panel.rotation = Rotation::quarter
//   tft.color565(r, g, b)                rgb565(r, g, b)
//   tft.setFont(&FreeSans18pt7b)         Style(24_px): any size of one font
//   tft.setTextColor(ink)                Rgb565Canvas canvas(strip, ink, paper)
//   tft.setCursor(x, y); tft.print("A")  painter.text(font, style, {x, y}, "A")
//   tft.getTextBounds("A", x, y, ...)    painter.box(font, style, {x, y}, "A")
//   tft.fillRect(...); tft.print(value)  run_double_buffer() over the box of
//                                        the value, without flicker
//
// There, after setFont(), as here y is that of the baseline. Text is UTF-8.
#include <fonts/room.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/kinetic/dirty_rects.hpp>
#include <inkcell/port/double_buffer.hpp>
#include <inkcell/port/st7789.hpp>

#include "your_board.hpp"

using namespace inkcell;
using namespace inkcell::port;

constexpr uint16_t kInk = rgb565(255, 255, 255);
constexpr uint16_t kPaper = rgb565(0, 50, 90);
constexpr Style kLabel = Style(24_px);
constexpr Style kValue = Style(80_px);
constexpr Point kValueAt = {16, 150};
constexpr int32_t kRows = 8;  // of a strip
alignas(4) static uint8_t strips[2][2 * 240 * kRows];

struct Screen {
  St7789 display;
  Font font;
  const char* value;
  Rect part = {0, 0, 240, 240};  // that is drawn and sent
  Strip place(Strip strip) const {
    strip.x0 += part.x0;
    strip.y0 += part.y0;
    return strip;
  }
};

static void draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  const Rgb565Canvas canvas(screen.place(strip), kInk, kPaper,
                            ByteOrder::high_first);
  const Painter painter(canvas);
  painter.text(screen.font, kLabel, {16, 48}, u8"\uE001 Living \u5BA2\u5385");
  painter.text(screen.font, kValue, kValueAt, screen.value);
}

static void flush(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  static_cast<void>(write(screen.display, screen.place(strip)));
}

static Status run() {
  Screen screen;
  DcsPanel& panel = screen.display.panel;
  panel.bus = {nullptr,    write_command, write_data,
               start_data, pulse_reset,   wait_ms};
  panel.width = panel.height = 240;
  panel.inverted = true;  // as on most of these panels
  INKCELL_TRY(Font::open(fonts::room, screen.font));
  INKCELL_TRY(init(screen.display));
  DoubleBuffer loop;
  loop.strips.buffer = strips[0];
  loop.second = strips[1];
  loop.strips.rows = kRows;
  loop.strips.context = &screen;
  loop.strips.draw = draw;
  loop.strips.flush = flush;
  loop.wait = wait_sent;
  for (;;) {
    screen.value = read_temperature();
    const Rect box = Painter().box(screen.font, kValue, kValueAt, screen.value);
    screen.part = kinetic::bounding_box(screen.part, box);
    loop.strips.width = screen.part.x1 - screen.part.x0;
    loop.strips.height = screen.part.y1 - screen.part.y0;
    loop.strips.stride = 2 * loop.strips.width;
    INKCELL_TRY(run_double_buffer(loop));
    screen.part = box;
    wait_ms(nullptr, 1000);
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
