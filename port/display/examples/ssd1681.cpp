// E-paper of 200 x 200 px, SSD1681 on SPI: a temperature. The first picture is
// a full refresh; then only the box of the value is sent and refreshed, with a
// full refresh from time to time, which removes the traces of old pixels.
//
// Coming from GxEPD2 or Adafruit_EPD, which draw by Adafruit_GFX:
//
//   GxEPD2_BW<GxEPD2_154_D67, ...>       Ssd1680 with EpaperController::ssd1681
//   display.init()                       init(display)
//   display.fillScreen(GxEPD_WHITE)      MonoRowsCanvas canvas(screen, 0, 1)
//   display.setTextColor(GxEPD_BLACK)    the 0 in it
//   display.setFont(&FreeSans24pt7b)     Style(72_px); small text with a Fit
//   display.setCursor(x, y); print("A")  painter.text(font, style, {x, y}, "A")
//   display.setFullWindow()              EpaperRefresh::full
//   display.setPartialWindow(x, y, w, h) a strip with that origin and size, and
//                                        EpaperRefresh::partial
//   do ... while (display.nextPage())    write() and refresh()
//   display.hibernate()                  sleep(display)
#include <fonts/paper.hpp>
#include <inkcell/fit.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/port/ssd1680.hpp>

#include "your_board.h"

using namespace inkcell;
using namespace inkcell::port;

constexpr Style kValue = Style(72_px);
constexpr Point kValueAt = {10, 120};
constexpr int32_t kStride = 200 / 8;
constexpr Rect kAll = {0, 0, 200, 200};
static uint8_t pixels[kStride * 200];

// Rows of the picture, from and to multiples of 8 px: a byte is never cut.
static Strip part_of(const Rect& box) {
  const int32_t x0 = box.x0 & ~7;
  const int32_t first = box.y0 * kStride + x0 / 8;
  return {{pixels + first, sizeof pixels - static_cast<size_t>(first)},
          x0,
          box.y0,
          ((box.x1 + 7) & ~7) - x0,
          box.y1 - box.y0,
          kStride};
}

static Status run() {
  Ssd1680 display;
  display.controller = EpaperController::ssd1681;
  display.width = display.height = 200;
  display.bus.command = write_command;
  display.bus.data = write_data;
  display.bus.reset = pulse_reset;
  display.bus.wait_idle = wait_idle;
  Font font;
  INKCELL_TRY(Font::open(fonts::paper, font));
  INKCELL_TRY(init(display));
  Style label(20_px);  // fitted to the grid of pixels, as small text should be
  FitOptions options;
  options.across = true;
  options.levels = 2;
  Fit fit;
  INKCELL_TRY(Fit::make(font, label, options, fit));
  label.set_fit(fit);

  Rect last;
  for (uint32_t count = 0;; ++count) {
    const char* const value = read_temperature();
    const MonoRowsCanvas canvas(part_of(kAll), 0, 1);  // black on white
    const Painter painter(canvas);
    painter.text(font, label, {10, 40}, "Outside, in \u00B0C");
    painter.text(font, kValue, kValueAt, value);

    const Rect box = painter.box(font, kValue, kValueAt, value);
    const bool is_full = count % 100 == 0;
    const Strip part = part_of(is_full ? kAll : bounding_box(last, box));
    INKCELL_TRY(write(display, part, EpaperPlane::next));
    INKCELL_TRY(refresh(
        display, is_full ? EpaperRefresh::full : EpaperRefresh::partial));
    INKCELL_TRY(write(display, part, EpaperPlane::shown));
    last = box;
    wait_ms(nullptr, 60000);
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
