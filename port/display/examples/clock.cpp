// A clock whose digits turn into each other, on a colour panel of 240 x 320 px,
// ILI9341 on SPI; any display of RGB565 will do. The points of the outlines
// move: MORPH in CMakeLists.txt makes a font that knows how.
//
// Coming from Adafruit_GFX or U8g2: there is no such call. A digit is
//
//   GFXcanvas16 canvas(w, h)             Rgb565Canvas on a strip
//   canvas.fillScreen(paper)             the third argument of Rgb565Canvas
//   canvas.setCursor(x, y); print('7')   digit.draw(painter, style, {x, y},
//                                            progress)
//   tft.drawRGBBitmap(x, y,              run_strips(loop, {x, y, x + w, y + h})
//       canvas.getBuffer(), w, h)
//   tft.setRotation(1)                   display.rotation = Rotation::quarter
//   tft.fillScreen(paper)                run_strips(loop)
#include <fonts/digits.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/motion/easing.hpp>
#include <inkcell/motion/outline_morph.hpp>
#include <inkcell/motion/timeline.hpp>
#include <inkcell/port/display_loop.hpp>
#include <inkcell/port/ili9341.hpp>

#include "your_board.h"

using namespace inkcell;
using namespace inkcell::motion;
using namespace inkcell::port;

constexpr uint16_t kInk = rgb565(255, 217, 160);
constexpr uint16_t kPaper = rgb565(11, 15, 22);
constexpr Style kStyle = Style(96_px, kFilterMotion);
constexpr int32_t kX[] = {20, 82, 176, 238};  // of the digits
constexpr Rect kDigits = {20, 81, 300, 159};
constexpr int32_t kBaseline = 155;
constexpr int32_t kFrames = 20;  // of a change
alignas(4) static uint8_t pixels[2 * 320 * 8];
alignas(4) static uint8_t points[4096];

struct Screen {
  Font font;
  OutlineMorph digits[4];
  Q16_16 progress;
};

static Status draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  const Rgb565Canvas canvas(strip, kInk, kPaper);
  const Painter painter(canvas, Workspace(points));
  painter.text(screen.font, kStyle, {144, kBaseline - 9}, ":");
  for (size_t i = 0; i < 4; ++i) {
    screen.digits[i].draw(painter, kStyle, {kX[i], kBaseline}, screen.progress);
  }
  return canvas.status();
}

// The digits of one time become those of another.
static Status set(Screen& screen, uint32_t from, uint32_t to) {
  constexpr uint32_t kMinutes[] = {600, 60, 10, 1};  // of a step of a digit
  constexpr uint32_t kSteps[] = {10, 10, 6, 10};
  for (size_t i = 0; i < 4; ++i) {
    const Font& font = screen.font;
    const uint16_t a =
        font.glyph_or_notdef('0' + from / kMinutes[i] % kSteps[i]);
    const uint16_t b = font.glyph_or_notdef('0' + to / kMinutes[i] % kSteps[i]);
    // A pair that the font does not hold changes at once.
    if (OutlineMorph::open(font, a, b, screen.digits[i]) != Status::ok) {
      INKCELL_TRY(OutlineMorph::open(font, b, b, screen.digits[i]));
    }
  }
  return Status::ok;
}

static Status run() {
  Ili9341 display;
  display.bus.command = write_command;
  display.bus.data = write_data;
  display.bus.reset = pulse_reset;
  display.bus.wait_ms = wait_ms;
  display.width = 240;
  display.height = 320;
  display.rotation = Rotation::quarter;
  display.mirror_columns = display.blue_first = true;  // as on most modules
  INKCELL_TRY(init(display));
  Screen screen;
  INKCELL_TRY(Font::open(fonts::digits, screen.font));
  if (OutlineMorph::workspace_bytes(screen.font) > sizeof points) {
    return Status::buffer_small;
  }
  StripLoop loop = loop_over(display, pixels);
  loop.context = &screen;
  loop.draw = draw;
  uint32_t shown = read_minutes();
  INKCELL_TRY(set(screen, shown, shown));
  INKCELL_TRY(run_strips(loop));
  for (;;) {
    const uint32_t now = read_minutes();
    INKCELL_TRY(set(screen, shown, now));
    for (int32_t i = 1; now != shown && i <= kFrames; ++i) {
      screen.progress = ease(kEaseInOut, fraction(0, kFrames, i));
      INKCELL_TRY(run_strips(loop, kDigits));
      wait_ms(nullptr, 20);
    }
    shown = now;
    wait_ms(nullptr, 1000);
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
