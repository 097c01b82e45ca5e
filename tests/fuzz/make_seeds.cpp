// Writes the seeds of the corpus: fonts as small as they can be.
//
//   fuzz_make_seeds tests/fuzz/corpus
#include <stdio.h>

#include <string>
#include <vector>

#include "font_builder.hpp"
#include "hints_record.hpp"

namespace {

using namespace font_builder;

// Even first byte: repaired; 16 px upright near the window, and a line.
const std::string kChoice =
    std::string("\0\0\3\0\0\10\0\0\1\0\20\0\0\1\2\0", 16) +
    "AB A\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\xff\xed\xa0\x80 "
    "ABBA AB AB AB A B BB AA AB AB";

bool write_seed(const std::string& path, const FontSpec& spec) {
  std::vector<uint8_t> font(1 << 14);
  font.resize(build_font(spec, {font.data(), font.size()}));
  std::string choice = kChoice;
  choice.resize(64, 'A');
  font.insert(font.end(), choice.begin(), choice.end());
  FILE* file = fopen(path.c_str(), "wb");
  if (file == nullptr) {
    fprintf(stderr, "fuzz_make_seeds: cannot write %s\n", path.c_str());
    return false;
  }
  const bool written = fwrite(font.data(), 1, font.size(), file) == font.size();
  return fclose(file) == 0 && written;
}

// One tile of 512 u with a slanted edge; and one divided to the end.
Record one_cell(bool divided) {
  Record record;
  record.tile_log2 = divided ? 2 : 9;
  record.tiles_x = 1;
  record.tiles_y = 1;
  record.reference_count = 1;
  const int8_t offsets[8] = {-60, -30, 0, -30, 30, 0, 30, 60};
  if (divided) {
    const uint16_t upper = record.add_node();
    const uint16_t lower = record.add_node();
    record.references[0] = upper;
    record.child(upper, 0) = inkcell::format::glyph::kInside;
    record.child(upper, 3) = lower;
    record.child(lower, 1) = record.add_raw_cell(0, offsets);
  } else {
    record.references[0] = record.add_raw_cell(0, offsets);
  }
  return record;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fprintf(stderr, "usage: fuzz_make_seeds FOLDER\n");
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  const CmapEntry cmap[] = {{'A', 1, 0}};
  const GlyphSpec empty[] = {{500, {}, nullptr, nullptr}};
  FontSpec spec;
  spec.glyphs = empty;
  bool written = write_seed(folder + "one_glyph_no_ink.seed", spec);

  const Record cells[] = {one_cell(false), one_cell(true)};
  const GlyphSpec glyphs[] = {{500, {0, 0, 500, 500}, nullptr, cells},
                              {600, {0, 0, 500, 500}, nullptr, cells + 1}};
  spec.glyphs = glyphs;
  spec.cmap = cmap;
  spec.name = "Seed";
  written &= write_seed(folder + "two_cells.seed", spec);

  const uint16_t classes[] = {1, 2};
  const int16_t values[4] = {-10, 20, -30, 40};
  spec.kerning = {2, 2, classes, classes, values};
  written &= write_seed(folder + "kerning.seed", spec);

  const std::vector<int16_t> wide(256, -1);
  spec.kerning = {1, 256, classes, classes, {wide.data(), wide.size()}};
  written &= write_seed(folder + "kerning_wide_classes.seed", spec);
  HintsRecord hints;
  hints.make_usual();
  spec.hints = hints.write(2);
  written &= write_seed(folder + "hints.seed", spec);
  return written ? 0 : 1;
}
