// least_both.cpp with strikes of any number of bits.
#include <fonts/least_any.hpp>
#include <inkcell/inkcell.hpp>
#include <inkcell/strike/outline_strike.hpp>

using namespace inkcell;

extern uint8_t pixels[1024];
uint8_t pixels[1024];

int main() {
  Font font;
  const Status status =
      Font::open(fonts::least_any, kOutlineStrikeCoding, font);
  const port::MonoPagesCanvas canvas({pixels, 0, 0, 128, 64, 128}, 1, 0);
  Painter(canvas).text(font, Style(12_px), {4, 28}, "12:34");
  return static_cast<int>(status);
}
