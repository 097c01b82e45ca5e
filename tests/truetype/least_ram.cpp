// The RAM that drawing a TrueType file wants in strips of 16 rows: all points
// of a glyph, and a strip in one band. More saves no work.
//
//   least_ram FONT MOST
//
// Prints it for ASCII at some sizes, for the glyph that wants most. Fails where
// that is more than MOST bytes.
#include <stdio.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/truetype/truetype_font.hpp"
#include "truetype_source.hpp"

namespace {

using namespace inkcell;

constexpr int32_t kWidth = 256;
constexpr int32_t kHeight = 144;
constexpr int32_t kRows = 16;
constexpr int32_t kStep = 16;  // of the RAM [bytes]

int32_t fills = 0;
bool has_all = true;

void count_fill(detail::GlyphJob& job) noexcept {
  ++fills;
  has_all = has_all && static_cast<detail::TrueTypeJob&>(job).has_all;
  kTrueTypeCoding.source->fill(job);
}

// Whether a glyph at this place is drawn from all its points at once, and each
// strip of it in one band.
bool is_enough(const Font& font, uint16_t glyph, Q26_6 size, int32_t bytes) {
  static uint64_t ram[1024];
  static uint8_t pixels[kWidth * kRows];
  for (int32_t y = 0; y < kHeight; y += kRows) {
    const port::A8Canvas canvas(
        {{pixels, sizeof pixels}, 0, y, kWidth, kRows, kWidth});
    fills = 0;
    has_all = true;
    const Point pen = {Q26_6::from_raw(40 * 64 + 37), 110_px};
    Painter(canvas,
            {reinterpret_cast<uint8_t*>(ram), static_cast<size_t>(bytes)})
        .glyph(font, Style(size), pen, glyph);
    if (fills > 1 || !has_all) {
      return false;
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fprintf(stderr, "usage: least_ram FONT MOST\n");
    return 2;
  }
  std::ifstream input(argv[1], std::ios::binary);
  const std::vector<uint8_t> file((std::istreambuf_iterator<char>(input)), {});
  detail::Source source = *kTrueTypeCoding.source;
  source.fill = count_fill;
  const Coding counted = {kTrueTypeCoding.number, &source};
  TrueTypeFont opened;
  if (opened.open({file.data(), file.size()}, counted) != Status::ok) {
    fprintf(stderr, "%s cannot be opened\n", argv[1]);
    return 1;
  }
  const Font& font = opened.font();
  int32_t most = 0;
  for (const int32_t px : {12, 24, 32, 48, 64, 96}) {
    int32_t wanted = 0;
    char of = 0;
    for (char letter = '!'; letter <= '~'; ++letter) {
      const uint16_t glyph = font.glyph_or_notdef(static_cast<uint8_t>(letter));
      int32_t bytes = wanted;
      while (!is_enough(font, glyph, Q26_6::from_int(px), bytes)) {
        bytes += kStep;
        of = letter;
      }
      wanted = bytes;
    }
    printf("%d px: %d bytes, for %c\n", px, wanted, of);
    most = std::max(most, wanted);
  }
  return most > 1000 && most <= atoi(argv[2]) ? 0 : 1;
}
