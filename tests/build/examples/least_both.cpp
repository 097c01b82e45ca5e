// least_oled.cpp with a strike beside the outlines: the same pixels, in a part
// of the time.
#include <fonts/least_both.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/strike/outline_strike.hpp>

using namespace inkcell;

extern uint8_t pixels[1024];
uint8_t pixels[1024];

int main() {
  Font font;
  const Status status =
      Font::open(fonts::least_both, kOutlineBitStrikeCoding, font);
  const port::MonoPagesCanvas canvas({pixels, 0, 0, 128, 64, 128}, 1, 0);
  Painter(canvas).text(font, Style(12_px), {4, 28}, "12:34");
  return static_cast<int>(status);
}
