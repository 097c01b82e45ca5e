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
#include "semihosting.hpp"
#include "stack.hpp"

namespace {

using namespace inkcell;
using bench::parse;
using bench::print_number;

constexpr size_t kMostLent = 4096;
constexpr size_t kPixelBytes = kCanvasWidth * kCanvasHeight * kCanvasMostBytes;
alignas(4) uint8_t font_bytes[1 << 20];
alignas(4) uint8_t pixels[kPixelBytes];
alignas(8) uint8_t lent[kMostLent];

bool open_font(const char* name) {
  const intptr_t file = semihosting::open(name, semihosting::Mode::read);
  const intptr_t length = file < 0 ? -1 : semihosting::length(file);
  const auto size = static_cast<size_t>(length);
  return length >= 0 && size <= sizeof font_bytes &&
         semihosting::read(file, font_bytes, size) &&
         canvas_open_font(font_bytes, size);
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
  board::print(canvas);
  print_number(px);
  print_number(bytes);
  print_number(instructions);
  print_number(stack);
  print_number(sum_of_pixels());
  board::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5 || !open_font(argv[1])) {
    board::print(
        "usage: FONT TEXT LENT,... PX..., or the font does not open\n");
    return 1;
  }
  for (int i = 4; i < argc; ++i) {
    const uint32_t px = parse(argv[i]);
    if (!canvas_set_size(static_cast<int32_t>(px))) {
      board::print("a size is out of range\n");
      return 1;
    }
    uint32_t number = 0;
    while (const char* const canvas = canvas_set(number++, pixels)) {
      const char* at = argv[3];
      do {
        const size_t bytes = parse(at);
        if (bytes > sizeof lent) {
          board::print("so much RAM is not lent\n");
          return 1;
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
