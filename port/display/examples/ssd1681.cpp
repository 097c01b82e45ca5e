// E-paper of 200 x 200 px, SSD1681 on SPI: a temperature. The first picture is
// a full refresh; then only the box of the value is sent and refreshed, with a
// full refresh from time to time, which removes the traces of old pixels.
//
// Coming from GxEPD2 or Adafruit_EPD, which draw by Adafruit_GFX:
//
//   GxEPD2_BW<GxEPD2_154_D67, ...>       Ssd1680 with EpaperController::ssd1681
//   display.init()                       init(display)
//   display.fillScreen(GxEPD_WHITE)      MonoRowsCanvas canvas(strip, 0, 1)
//   display.setTextColor(GxEPD_BLACK)    the 0 in it
//   display.setFont(&FreeSans24pt7b)     Style(72_px)
//   display.setCursor(x, y); print("A")  painter.text(font, style, {x, y}, "A")
//   display.setFullWindow()              EpaperRefresh::full
//   display.setPartialWindow(x, y, w, h) run_strips() with that rectangle, and
//                                        EpaperRefresh::partial
//   do ... while (display.nextPage())    run_strips(), write() and refresh()
//   display.hibernate()                  sleep(display)
#include <fonts/paper.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/port/display_loop.hpp>
#include <inkcell/port/ssd1680.hpp>

#include "your_board.h"

using namespace inkcell;
using namespace inkcell::port;

constexpr Style kValue = Style(72_px);
static uint8_t pixels[200 * 200 / 8];  // the picture, in one strip

struct Screen {
  Ssd1680 display;
  EpaperRefresh kind;
  const Font& font;
  const Style& label;
  ValueLabel value;
};

static Status draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  const MonoRowsCanvas canvas(strip, 0, 1);  // black on white
  Painter(canvas).text(screen.font, screen.label, {10, 40},
                       "Outside, in \u00B0C");
  screen.value.draw(canvas);
  return canvas.status();
}

static Status flush(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  INKCELL_TRY(write(screen.display, strip, EpaperPlane::next));
  INKCELL_TRY(refresh(screen.display, screen.kind));
  return write(screen.display, strip, EpaperPlane::shown);
}

static Status run() {
  Font font;
  INKCELL_TRY(Font::open(fonts::paper, font));
  constexpr Style label(20_px);
  Screen screen = {{}, {}, font, label, ValueLabel(font, kValue, {10, 120})};
  Ssd1680& display = screen.display;
  display.controller = EpaperController::ssd1681;
  display.width = display.height = 200;
  display.bus.command = write_command;
  display.bus.data = write_data;
  display.bus.reset = pulse_reset;
  display.bus.wait_idle = wait_idle;
  INKCELL_TRY(init(display));

  StripLoop loop = loop_over(display, pixels);
  loop.context = loop.display = &screen;
  loop.draw = draw;
  loop.flush = flush;
  for (uint32_t count = 0;; ++count) {
    const Rect changed = screen.value.set(read_temperature(), MonoRowsCanvas());
    const bool is_full = count % 100 == 0;
    screen.kind = is_full ? EpaperRefresh::full : EpaperRefresh::partial;
    INKCELL_TRY(is_full ? run_strips(loop) : run_strips(loop, changed));
    wait_ms(nullptr, 60000);
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
