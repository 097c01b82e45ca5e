// What StoredTrueType reads for a text, and that it draws what TrueTypeFont
// does.
//
//   stored_reads FONT TEXT_FILE BLOCKS MOST
//
// Draws the lines of a text once, kerned, in blocks of 512 bytes. Fails where
// the mean glyph takes more than MOST reads.
#include <stdio.h>
#include <stdlib.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "inkcell/painter.hpp"
#include "inkcell/port/a8.hpp"
#include "inkcell/text.hpp"
#include "inkcell/truetype/stored_truetype.hpp"
#include "inkcell/truetype/truetype_font.hpp"

namespace {

using namespace inkcell;
using Bytes = std::vector<uint8_t>;

constexpr int32_t kWidth = 640;
constexpr int32_t kHeight = 24;

bool read(void* context, uint32_t offset, uint8_t* bytes, uint32_t count) {
  const Bytes& file = *static_cast<const Bytes*>(context);
  if (offset >= file.size()) {
    return false;
  }
  const size_t rest = file.size() - offset;
  std::copy_n(file.begin() + offset, std::min<size_t>(rest, count), bytes);
  return true;
}

Bytes draw(const Font& font, const std::string& line) {
  static uint64_t ram[320];
  Bytes pixels(kWidth * kHeight);
  const port::A8Canvas canvas(
      {{pixels.data(), pixels.size()}, 0, 0, kWidth, kHeight, kWidth});
  Painter(canvas, {reinterpret_cast<uint8_t*>(ram), sizeof ram})
      .text(font, Style(16_px), {2_px, 18_px}, {line.data(), line.size()});
  return pixels;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) {
    fprintf(stderr, "usage: stored_reads FONT TEXT_FILE BLOCKS MOST\n");
    return 2;
  }
  std::ifstream input(argv[1], std::ios::binary);
  Bytes file((std::istreambuf_iterator<char>(input)), {});
  std::ifstream text(argv[2]);
  const auto blocks = static_cast<size_t>(atoi(argv[3]));
  std::vector<uint64_t> lent(StoredTrueType::ram_bytes(blocks) / 8);
  StoredTrueType stored;
  TrueTypeFont same;
  if (StoredTrueType::open(
          {read, &file},
          {reinterpret_cast<uint8_t*>(lent.data()), 8 * lent.size()},
          stored) != Status::ok ||
      same.open({file.data(), file.size()}) != Status::ok) {
    fprintf(stderr, "%s cannot be opened\n", argv[1]);
    return 1;
  }
  const uint32_t opening = stored.stats().reads;
  size_t glyphs = 0;
  bool is_same = true;
  for (std::string line; std::getline(text, line);) {
    glyphs += line.size();
    is_same = is_same && draw(stored.font(), line) == draw(same.font(), line);
  }
  const uint32_t reads = stored.stats().reads - opening;
  const double mean = glyphs == 0 ? 0 : reads / static_cast<double>(glyphs);
  printf(
      "%s: %zu blocks, %zu bytes lent, %u reads to open, %.2f a glyph of "
      "%zu%s\n",
      argv[1], blocks, 8 * lent.size(), opening, mean, glyphs,
      is_same ? "" : "; draws something else than from memory");
  return is_same && glyphs > 500 && mean <= atof(argv[4]) &&
                 stored.status() == Status::ok
             ? 0
             : 1;
}
