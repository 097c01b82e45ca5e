// Calls the README's functions and looks whether they drew their line of text.
#include <stdio.h>
#include <inkcell/font.hpp>
#include <inkcell/port/pixel.hpp>
#include <inkcell/port/rgb565.hpp>
#include <inkcell/status.hpp>
#include <inkcell/strip.hpp>
#include <inkcell/text.hpp>

inkcell::Status hello(const inkcell::Strip& strip);

// Nobody calls it, so that nothing of what it calls is linked.
inkcell::Status uncalled(const inkcell::Font& font) {
  return font.verify();
}

namespace {

constexpr int32_t kWidth = 160;
constexpr int32_t kHeight = 40;
constexpr auto kFormat = inkcell::port::PixelFormat::rgb565;

// A screen in RAM, black.
struct Screen {
  uint8_t bytes[inkcell::port::strip_bytes(kFormat, kWidth, kHeight)] = {};
  inkcell::Strip strip;

  Screen() {
    strip.pixels = bytes;
    strip.width = kWidth;
    strip.height = kHeight;
    strip.stride = inkcell::port::stride_bytes(kFormat, kWidth);
  }
};

}  // namespace

int main() {
  Screen screen;
  if (hello(screen.strip) != inkcell::Status::ok) {
    puts("the README's program fails");
    return 1;
  }
  // Twelve characters of 24 px: some 12 x 60 px of stems, on a few rows only.
  int white = 0;
  int inked_rows = 0;
  for (int32_t y = 0; y < kHeight; ++y) {
    bool inked = false;
    for (int32_t x = 0; x < kWidth; ++x) {
      const uint8_t* pixel = screen.bytes + y * screen.strip.stride + 2 * x;
      white += pixel[0] == 0xff && pixel[1] == 0xff ? 1 : 0;
      inked = inked || pixel[0] != 0 || pixel[1] != 0;
    }
    inked_rows += inked ? 1 : 0;
  }
  printf("%d white pixels on %d rows\n", white, inked_rows);
  return white > 250 && white < 1500 && inked_rows >= 18 && inked_rows <= 26
             ? 0
             : 1;
}
