// Strikes are drawn as they are; a paper removes the old value.
#include "Adafruit_SSD1306_Strikes.ino"
#include "expected.hpp"

using inkcell::Style;
using namespace inkcell::literals;

static uint8_t wanted[128 * 64 / 8];

int main() {
  setup();
  loop();
  loop();
  inkcell::Font small;
  inkcell::Font large;
  if (inkcell::Font::open(fonts::sans_11, inkcell::kBitStrikeCoding, small) !=
          inkcell::Status::ok ||
      inkcell::Font::open(fonts::digits_24, inkcell::kBitStrikeCoding, large) !=
          inkcell::Status::ok) {
    return 1;
  }
  const inkcell::port::MonoPagesCanvas canvas(
      inkcell::port::whole_picture(
          wanted, inkcell::port::PixelFormat::mono_pages, 128, 64),
      1);
  const inkcell::Painter painter(canvas);
  const Style style(11_px);
  const int ascent = inkcell::baseline({small, style}).floor();
  const int line = inkcell::line_height({small, style}).floor();
  painter.text(small, style, {0, ascent}, "Pump 2 is running dry.");
  painter.text(small, style, {0, ascent + line}, "Close the valve.");
  painter.text(large, Style(24_px), {0, 58}, "2");
  const bool is_refused = !text.setStrikes(fonts::sans_11, 12) &&
                          text.setStrikes(fonts::sans_11, 22);
  return is_refused ? compare("Adafruit_SSD1306, strikes", oled.getBuffer(),
                              wanted, 128 * 64 / 8)
                    : 1;
}
