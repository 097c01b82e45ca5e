// Draws a line of text into each canvas, with more and less RAM lent.
//
//   FIRMWARE FONT TEXT LENT,... PX...
//
// Prints for each canvas, size and RAM:
//
//   CANVAS PX LENT INSTRUCTIONS STACK INK
#include "canvases.h"

#include "board.hpp"
#include "console.hpp"
#include "counter.hpp"
#include "stack.hpp"

namespace {

using namespace inkcell;
using bench::parse;

constexpr size_t kMostLent = 4096;
constexpr size_t kPixelBytes = kCanvasWidth * kCanvasHeight * kCanvasMostBytes;
alignas(4) uint8_t font_bytes[1 << 20];
alignas(4) uint8_t pixels[kPixelBytes];
alignas(8) uint8_t lent[kMostLent];

bool open_font(const char* name) {
  return canvas_open_font(
      font_bytes, bench::read_file(name, font_bytes, sizeof font_bytes));
}

void clear_pixels() {
  for (uint8_t& byte : pixels) {
    byte = 0;
  }
}

// Adler-32 of what was drawn: pictures are equal for any RAM.
uint32_t sum_of_pixels() {
  uint32_t a = 1;
  uint32_t b = 0;
  for (const uint8_t byte : pixels) {
    a = (a + byte) % 65521;
    b = (b + a) % 65521;
  }
  return b << 16 | a;
}

void measure(const char* canvas, uint32_t px, const char* text, size_t bytes) {
  const auto work = [text, bytes] { canvas_draw(text, lent, bytes); };
  clear_pixels();
  const size_t stack = board::count_stack(work);
  clear_pixels();
  const uint32_t instructions = board::count_instructions(work);
  bench::print_row(canvas, px, bytes, instructions, stack, sum_of_pixels());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5 || !open_font(argv[1])) {
    return bench::fail(
        "usage: FONT TEXT LENT,... PX..., or the font does not open");
  }
  for (int i = 4; i < argc; ++i) {
    const uint32_t px = parse(argv[i]);
    if (!canvas_set_size(static_cast<int32_t>(px))) {
      return bench::fail("a size is out of range");
    }
    uint32_t number = 0;
    while (const char* const canvas = canvas_set(number++, pixels)) {
      const char* at = argv[3];
      do {
        const size_t bytes = parse(at);
        if (bytes > sizeof lent) {
          return bench::fail("so much RAM is not lent");
        }
        measure(canvas, px, argv[2], bytes);
        while (*at != '\0' && *at != ',') {
          ++at;
        }
      } while (*at++ == ',');
    }
  }
  return 0;
}
