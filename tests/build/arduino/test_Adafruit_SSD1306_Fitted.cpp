// 1-bit text is fitted to the grid of pixels; a paper removes the old value.
#include "Adafruit_SSD1306_Fitted.ino"
#include "expected.hpp"

static uint8_t wanted[128 * 64 / 8];

int main() {
  setup();
  loop();
  loop();
  const Expected small(fonts::dejavu_sans_latin1, 11, true);
  const Expected large(fonts::dejavu_sans_latin1, 24, true);
  const inkcell::port::MonoPagesCanvas canvas(
      inkcell::port::whole_picture(
          wanted, inkcell::port::PixelFormat::mono_pages, 128, 64),
      1);
  small.draw(canvas, 0, small.ascent(), "Pump 2 is running dry. ");
  small.draw(canvas, 0, small.ascent() + small.line(), "Close the valve.");
  large.draw(canvas, 0, 58, "2");
  return compare("Adafruit_SSD1306", oled.getBuffer(), wanted, 128 * 64 / 8);
}
