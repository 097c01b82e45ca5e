// The smallest program that draws text on a display of 1 bit: digits and
// capitals of one face, fitted to the grid of pixels.
#include <fonts/least_oled.hpp>
#include <inkcell/inkcell.hpp>

using namespace inkcell;

extern uint8_t pixels[1024];
uint8_t pixels[1024];

int main() {
  Font font;
  const Status status = Font::open(fonts::least_oled, font);
  const port::MonoPagesCanvas canvas({pixels, 0, 0, 128, 64, 128}, 1, 0);
  Painter(canvas).text(font, Style(12_px), {4, 28}, "12:34");
  return static_cast<int>(status);
}
