// A clock whose digits turn into each other, on a colour panel of 240 x 320 px,
// ILI9341 on SPI; any display of RGB565 will do. Digits change one after the
// other, so that one GlyphMorph and the pixels of one digit are enough RAM.
//
// Coming from Adafruit_GFX or U8g2: there is no such call. A digit's box is
//
//   GFXcanvas16 canvas(w, h)             Strip, and Rgb565Canvas on it
//   canvas.fillScreen(paper)             the third argument of Rgb565Canvas
//   canvas.setCursor(x, y); print('7')   morph.draw(x, y, canvas)
//   tft.drawRGBBitmap(x, y,              write(display, strip)
//       canvas.getBuffer(), w, h)
//   tft.setRotation(1)                   display.rotation = Rotation::quarter
//   tft.fillScreen(paper)                strips of paper, sent by write()
#include <fonts/digits.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/kinetic/easing.hpp>
#include <inkcell/kinetic/morph.hpp>
#include <inkcell/kinetic/timeline.hpp>
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

static Rgb565Canvas paper(int32_t x, int32_t y, int32_t width, int32_t height) {
  return Rgb565Canvas(
      {pixels, x, y, width, height, 2 * width, ByteOrder::high_first}, kInk,
      kPaper);
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
  for (int32_t y = 0; y < 240; y += 10) {
    INKCELL_TRY(write(display, paper(0, y, 320, 10).strip()));
  }
  Font font;
  INKCELL_TRY(Font::open(fonts::digits, font));
  const Rgb565Canvas colon = paper(144, kY, 32, kBox.height);
  Painter(colon).text(font, kStyle, {144, kY + kBox.baseline - 9}, ":");
  INKCELL_TRY(write(display, colon.strip()));

  GlyphMorph morph(font, kStyle.size(), kStyle.filter(), kBox, grids);
  uint32_t shown = read_minutes();
  for (bool is_first = true;; is_first = false) {
    const uint32_t now = read_minutes();
    for (size_t digit = 4; digit-- > 0;) {
      const uint16_t from = glyph_of(font, shown, digit);
      const uint16_t to = glyph_of(font, now, digit);
      if (from == to && !is_first) {
        continue;
      }
      INKCELL_TRY(morph.set(from, to));
      for (int32_t frame = 1; frame <= kFrames; ++frame) {
        morph.step(ease(kEaseInOut, fraction(0, kFrames, frame)), scratch);
        const Rgb565Canvas canvas =
            paper(kX[digit], kY, kBox.width, kBox.height);
        morph.draw(kX[digit], kY, canvas);
        INKCELL_TRY(write(display, canvas.strip()));
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
