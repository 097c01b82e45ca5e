// A program that opens fonts of the coding PROBE_CODING, and no others: prints
// what Font::open answers for each file that is named, and the ink of a word.
#include <stdint.h>
#include <stdio.h>

#include <vector>

#include "inkcell/field/draw.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/port/mono_pages.hpp"

using namespace inkcell;

static bool show(Span<const uint8_t> rom) {
  constexpr int32_t kSide = 128;
  std::vector<uint8_t> pixels(kSide * kSide);
  const port::A8Canvas canvas(
      {{pixels.data(), pixels.size()}, 0, 0, kSide, kSide, kSide});
  const Style style(24_px, kFilterText);
  if (canvas.status() != Status::ok) {
    return false;
  }
  Font font;
  const Status status = Font::open(rom, PROBE_CODING, font);
  Painter(canvas).text(font, style, {Q26_6::from_int(4), Q26_6::from_int(40)},
                       "Again");
  // A canvas of 1 bit, whose painters fit outlines.
  static uint8_t bits[kSide * kSide / 8];
  const port::MonoPagesCanvas mono({bits, 0, 0, kSide, kSide, kSide}, 1, 0);
  Painter(mono).text(font, Style(12_px), {4, 40}, "Again");
  int32_t ink = 0;
  for (const uint8_t pixel : pixels) {
    ink += pixel;
  }
  printf("%d %d\n", static_cast<int>(status), ink > 9999 ? 1 : 0);
  return true;
}

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    FILE* file = fopen(argv[i], "rb");
    if (file == nullptr) {
      return 1;
    }
    std::vector<uint32_t> words(1 << 14);
    const size_t size = fread(words.data(), 1, words.size() * 4, file);
    fclose(file);
    if (!show({reinterpret_cast<const uint8_t*>(words.data()), size})) {
      return 1;
    }
  }
  return 0;
}
