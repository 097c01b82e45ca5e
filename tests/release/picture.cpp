// Writes a picture of a line of text, as PGM: the same one with each piece of a
// release that has the library.
#include <stdio.h>

#if __has_include("inkcell.hpp")
#  include "inkcell.hpp"  // of the two files
#else
#  include <inkcell/inkcell.hpp>
#  include <inkcell/port/grey8.hpp>
#endif
#include <fonts/sans.hpp>

using namespace inkcell;

int main() {
  constexpr int kWidth = 200;
  constexpr int kHeight = 40;
  static uint8_t pixels[kWidth * kHeight];
  Strip strip;
  strip.pixels = pixels;
  strip.width = kWidth;
  strip.height = kHeight;
  strip.stride = kWidth;
  Font font;
  if (Font::open(fonts::sans, font) != Status::ok) {
    return 1;
  }
  port::Grey8Canvas canvas(strip);
  Painter painter(canvas);
  painter.text(font, Style(24_px), {4, 28}, "Hello, 12:34");
  printf("P5 %d %d 255\n", kWidth, kHeight);
  const size_t written = fwrite(pixels, 1, sizeof(pixels), stdout);
  return canvas.status() == Status::ok && written == sizeof(pixels) ? 0 : 1;
}
