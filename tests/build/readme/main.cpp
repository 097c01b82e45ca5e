// Calls the README's program and looks whether it drew its line of text.
#include <inkcell/port/pixel.hpp>
#include <inkcell/status.hpp>
#include <inkcell/strip.hpp>
#include <stdio.h>

inkcell::Status hello(const inkcell::Strip& strip);

namespace {

constexpr int32_t kWidth = 160;
constexpr int32_t kHeight = 40;
constexpr auto kFormat = inkcell::port::PixelFormat::rgb565;

}  // namespace

int main() {
  uint8_t bytes[inkcell::port::strip_bytes(kFormat, kWidth, kHeight)] = {};
  inkcell::Strip strip;
  strip.pixels = bytes;
  strip.width = kWidth;
  strip.height = kHeight;
  strip.stride = inkcell::port::stride_bytes(kFormat, kWidth);
  if (hello(strip) != inkcell::Status::ok) {
    puts("the README's program fails");
    return 1;
  }
  // Twelve characters of 24 px: some 12 x 60 px of stems, on a few rows only.
  int white = 0;
  int inked_rows = 0;
  for (int32_t y = 0; y < kHeight; ++y) {
    bool inked = false;
    for (int32_t x = 0; x < kWidth; ++x) {
      const uint8_t* pixel = bytes + y * strip.stride + 2 * x;
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
