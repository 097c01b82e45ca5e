// A clock whose digits turn into each other, on a colour panel of 240 x 320 px,
// ILI9341 on SPI; any display of RGB565 will do. Digits change one after the
// other, so that one GlyphMorph and the pixels of one digit are enough RAM.
//
// Coming from Adafruit_GFX or U8g2: there is no such call. A digit's box is
//
//   GFXcanvas16 canvas(w, h)             Rgb565Canvas on a strip
//   canvas.fillScreen(paper)             the third argument of Rgb565Canvas
//   canvas.setCursor(x, y); print('7')   morph.draw(x, y, canvas)
//   tft.drawRGBBitmap(x, y,              run_strips(loop, {x, y, x + w, y + h})
//       canvas.getBuffer(), w, h)
//   tft.setRotation(1)                   display.rotation = Rotation::quarter
//   tft.fillScreen(paper)                run_strips(loop)
#include <fonts/digits.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/kinetic/easing.hpp>
#include <inkcell/kinetic/morph.hpp>
#include <inkcell/kinetic/timeline.hpp>
#include <inkcell/port/display_loop.hpp>
#include <inkcell/port/ili9341.hpp>

#include "your_board.h"

using namespace inkcell;
using namespace inkcell::kinetic;
using namespace inkcell::port;

constexpr uint16_t kInk = rgb565(255, 217, 160);
constexpr uint16_t kPaper = rgb565(11, 15, 22);
constexpr Style kStyle = Style(96_px, kFilterMotion);
constexpr MorphBox kBox = {62, 78, 74, 1};    // width, height, baseline, scale
constexpr int32_t kX[] = {20, 82, 176, 238};  // of the digits
constexpr int32_t kY = 81;
constexpr int32_t kFrames = 20;  // of a change
alignas(4) static uint8_t pixels[2 * 62 * 78];
static int8_t grids[morph_bytes(kBox)];
static GridHistogram scratch;

// A digit of the time: 0 is that of ten hours.
static uint16_t glyph_of(const Font& font, uint32_t minutes, size_t digit) {
  const uint32_t digits[] = {minutes / 600, minutes / 60 % 10, minutes / 10 % 6,
                             minutes % 10};
  return font.glyph_or_notdef('0' + digits[digit]);
}

struct Screen {
  Font font;
  GlyphMorph* morph;
  size_t digit = 4;  // that changes; 4: none
};

static Status draw(void* context, const Strip& strip) {
  const Screen& screen = *static_cast<const Screen*>(context);
  const Rgb565Canvas canvas(strip, kInk, kPaper);
  Painter(canvas).text(screen.font, kStyle, {144, kY + kBox.baseline - 9}, ":");
  if (screen.digit < 4) {
    screen.morph->draw(kX[screen.digit], kY, canvas);
  }
  return canvas.status();
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
  StripLoop loop = loop_over(display, pixels);
  loop.context = &screen;
  loop.draw = draw;
  INKCELL_TRY(run_strips(loop));

  const Font& font = screen.font;
  GlyphMorph morph(font, kStyle.size(), kStyle.filter(), kBox, grids);
  screen.morph = &morph;
  uint32_t shown = read_minutes();
  for (bool is_first = true;; is_first = false) {
    const uint32_t now = read_minutes();
    for (screen.digit = 4; screen.digit-- > 0;) {
      const uint16_t from = glyph_of(font, shown, screen.digit);
      const uint16_t to = glyph_of(font, now, screen.digit);
      if (from == to && !is_first) {
        continue;
      }
      INKCELL_TRY(morph.set(from, to));
      const int32_t x = kX[screen.digit];
      for (int32_t frame = 1; frame <= kFrames; ++frame) {
        morph.step(ease(kEaseInOut, fraction(0, kFrames, frame)), scratch);
        INKCELL_TRY(
            run_strips(loop, {x, kY, x + kBox.width, kY + kBox.height}));
        wait_ms(nullptr, 20);
      }
    }
    shown = now;
    wait_ms(nullptr, 1000);
  }
}

int main() {
  return static_cast<int>(run());  // returns if something is wrong
}
