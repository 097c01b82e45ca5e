// A gauge on a colour panel of 240 x 240 px, ST7789 on SPI: an arc with round
// ends, marks around it, and the number. When the value changes, the part of
// the arc between the old and the new one and the number are drawn and sent.
//
// Coming from Adafruit_GFX, TFT_eSPI or LVGL:
//
//   tft.drawArc(x, y, r, ir, 45, 315, c)  stroke(painter, arc(...), {width})
//   tft.drawSmoothArc(..., true)          Cap::round
//   tft.fillCircle(x, y, r, c)            fill(painter, circle({x, y}, r))
//   tft.drawWideLine(x, y, xe, ye, w, c)  stroke(painter, line(a, b), {w})
//   lv_arc_set_value(arc, 71)             run_strips(loop, stroke_box(...))
#include <fonts/gauge_digits.hpp>
#include <inkcell/dirty_rects.hpp>
#include <inkcell/figures/figures.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/port/display_loop.hpp>
#include <inkcell/port/st7789.hpp>

#include "your_board.h"

using namespace inkcell;
using namespace inkcell::figures;
using namespace inkcell::port;

constexpr uint16_t kPaper = rgb565(16, 20, 28);
constexpr uint16_t kTrack = rgb565(52, 60, 76);
constexpr uint16_t kFull = rgb565(80, 200, 120);
constexpr uint16_t kLow = rgb565(240, 96, 64);
constexpr uint16_t kInk = rgb565(240, 240, 240);
constexpr Style kNumber = Style(64_px);
constexpr Pen kRing = {18_px, Cap::round};
constexpr Pen kMark = {3_px, Cap::round};
constexpr int32_t kLowest = 20;
constexpr Rect kScreen = {0, 0, 240, 240};
alignas(4) static uint8_t pixels[2 * 240 * 16];
alignas(4) static uint8_t ram[2560];

struct Screen {
  const Font& font;
  ValueLabel number;
  int32_t percent;
};

// What the needle passes from one value to another: 270 degrees for 100.
static Figure dial(int32_t from, int32_t to) {
  constexpr int32_t kTurn = 65536 * 3 / 4;
  const auto begin = motion::from_degrees(225).raw - from * kTurn / 100;
  return arc({120, 120}, 96_px,
             motion::Angle::from_raw(static_cast<uint16_t>(begin)),
             Q16_16::from_raw((from - to) * kTurn / 100));
}

static Status draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  Rgb565Canvas canvas(strip, kTrack, kPaper);
  const Painter painter(canvas, Workspace(ram));
  stroke(painter, dial(0, 100), kRing);
  canvas.set_colour(screen.percent < kLowest ? kLow : kFull);
  stroke(painter, dial(0, screen.percent), kRing);
  canvas.set_colour(kInk);
  for (int32_t mark = 0; mark <= 4; ++mark) {
    // Inside of the ring, from 70 to 78 px from its centre.
    const motion::Angle at = motion::from_degrees(225 - 270 * mark / 4);
    const auto place = [&](int32_t px) {
      return Point(
          Q26_6::from_raw(120 * 64 + px * motion::cosine(at).raw / 256),
          Q26_6::from_raw(120 * 64 - px * motion::sine(at).raw / 256));
    };
    stroke(painter, line(place(70), place(78)), kMark);
  }
  screen.number.draw(painter);
  return canvas.status();
}

static Status run() {
  St7789 display;
  display.bus.command = write_command;
  display.bus.data = write_data;
  display.bus.reset = pulse_reset;
  display.bus.wait_ms = wait_ms;
  display.width = display.height = 240;
  display.inverted = true;  // as on most of these panels
  INKCELL_TRY(init(display));
  Font font;
  INKCELL_TRY(Font::open(fonts::gauge_digits, font));
  const auto percent = static_cast<int32_t>(read_percent());
  Screen screen = {font, {font, kNumber, {120, 142}, Anchor::centre}, percent};
  screen.number.set(NumberText(percent, 0), {});
  StripLoop loop = loop_over(display, pixels);
  loop.context = &screen;
  loop.draw = draw;
  INKCELL_TRY(run_strips(loop));
  for (;;) {
    wait_ms(nullptr, 100);
    const auto next = static_cast<int32_t>(read_percent());
    Rect room[2];
    DirtyRects dirty(room);
    const bool recolours = (screen.percent < kLowest) != (next < kLowest);
    const Figure part = recolours ? dial(0, 100) : dial(screen.percent, next);
    dirty.add(stroke_box(part, kRing), kScreen);
    dirty.add(screen.number.set(NumberText(next, 0), {}), kScreen);
    screen.percent = next;
    for (const Rect& changed : dirty.rects()) {
      INKCELL_TRY(run_strips(loop, changed));
    }
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
