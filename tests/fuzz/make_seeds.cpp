// Writes the seeds of the corpora: fonts as small as they can be, and outlines.
//
//   fuzz_make_seeds tests/fuzz/corpus tests/fuzz/corpus_outline
//     tests/fuzz/corpus_moving tests/fuzz/corpus_strike
//     tests/fuzz/corpus_truetype
#include <stdio.h>

#include <string>
#include <vector>

#include "font_builder.hpp"
#include "grid_record.hpp"
#include "outline_input.hpp"
#include "outline_record.hpp"
#include "random.hpp"
#include "sfnt_font.hpp"
#include "strike_font.hpp"

namespace {

using namespace font_builder;

// Even first byte: repaired; 16 px upright near the window, and a line.
const std::string kChoice =
    std::string("\0\0\3\0\0\10\0\0\1\0\20\0\0\1\2\0", 16) +
    "AB A\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80\xff\xed\xa0\x80 "
    "ABBA AB AB AB A B BB AA AB AB";

bool write_file(const std::string& path, const std::vector<uint8_t>& bytes) {
  FILE* file = fopen(path.c_str(), "wb");
  if (file == nullptr) {
    fprintf(stderr, "fuzz_make_seeds: cannot write %s\n", path.c_str());
    return false;
  }
  const bool written =
      fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  return fclose(file) == 0 && written;
}

bool write_seed(const std::string& path, const FontSpec& spec) {
  std::vector<uint8_t> font(1 << 14);
  font.resize(build_font(spec, {font.data(), font.size()}));
  std::string choice = kChoice;
  choice.resize(64, 'A');
  font.insert(font.end(), choice.begin(), choice.end());
  return write_file(path, font);
}

namespace input = outline_input;
using inkcell::Span;
using outline_record::OutlinePoint;

// Glyph 1 at 16 px, upright, in the picture; the next choices differ from seed
// to seed.
std::vector<uint8_t> outline_choice(uint8_t number) {
  std::vector<uint8_t> choice(input::kBytes);
  choice[input::kCodeBits] = outline_record::kCodeBits - 1;
  choice[input::kGridShift] = 4;
  put_u16(&choice[input::kEm], 1024);
  put_u16(&choice[input::kMaxPoints], 100);
  put_u16(&choice[input::kSize], 16 * 64 - 256 + 200u * number);
  choice[input::kFilter] = number;
  choice[input::kEffect] = static_cast<uint8_t>(number / 2);
  choice[input::kMap] = static_cast<uint8_t>(number / 3);
  choice[input::kGlyph] = 1;
  put_u32(&choice[input::kOrigin + 4], 14 * 64 + 21);
  choice[input::kCut] = 9;
  choice[input::kCut + 1] = 6;
  put_u16(&choice[input::kWorkspaces], 2560);
  put_u16(&choice[input::kWorkspaces + 2], 720);
  choice[input::kOdd] = 1;
  return choice;
}

// The same shape as points, to 1/64 em, and as a record with a composite of it.
bool write_outline_seeds(const std::string& folder,
                         const char* name,
                         uint8_t number,
                         Span<const OutlinePoint> points) {
  std::vector<uint8_t> seed = outline_choice(number);
  seed[input::kFlags] = input::kHasPoints;
  int32_t x = 0;
  int32_t y = 0;
  for (const OutlinePoint& at : points) {
    const int32_t dx = at.x - x;
    const int32_t dy = at.y - y;
    seed.push_back(at.kind);
    seed.push_back(static_cast<uint8_t>((dx - (dx & 15)) / 32));
    seed.push_back(static_cast<uint8_t>((dy - (dy & 15)) / 32));
    seed.push_back(static_cast<uint8_t>((dx & 15) | (dy & 15) << 4));
    x = at.x;
    y = at.y;
  }
  if (!write_file(folder + name + "_points.seed", seed)) {
    return false;
  }
  seed = outline_choice(number);
  const outline_record::PointBox box = outline_record::box_of(points);
  const int32_t sides[] = {box.x_min, box.y_min, box.x_max, box.y_max};
  for (uint32_t i = 0; i < 4; ++i) {
    put_u16(&seed[input::kBoxes + 2 * i], static_cast<uint16_t>(sides[i]));
    put_u16(&seed[input::kBoxes + 8 + 2 * i], static_cast<uint16_t>(sides[i]));
  }
  uint8_t code[2 << outline_record::kCodeBits];
  outline_record::write_code(code);
  if (number % 2 != 0) {
    // Two alike, read by turns.
    constexpr int kTable = 1 << (inkcell::format::outline::kTableShift - 8);
    for (size_t i = 1; i < sizeof(code); i += 2) {
      code[i] = static_cast<uint8_t>(code[i] | kTable);
    }
    seed.insert(seed.end(), code, code + sizeof(code));
    seed[input::kCodeBits] = 64 + 2;
    static_assert((64 + 2) % 7 + 1 == outline_record::kCodeBits);
  }
  seed.insert(seed.end(), code, code + sizeof(code));
  std::vector<uint8_t> record(512);
  record.resize(
      outline_record::write_outline(points, {record.data(), record.size()}));
  seed[input::kSizes] = static_cast<uint8_t>(record.size());
  seed.insert(seed.end(), record.begin(), record.end());
  const outline_record::Component parts[] = {
      {1, 0, 0}, {1, 300, -40, true, {9000, -8192, 8192, 12000}}};
  record.assign(64, 0);
  record.resize(
      outline_record::write_composite(parts, {record.data(), record.size()}));
  seed.insert(seed.end(), record.begin() + 1, record.end());
  return write_file(folder + name + "_record.seed", seed);
}

bool write_all_outline_seeds(const std::string& folder) {
  using namespace outline_record;
  struct Shape {
    const char* name;
    Span<const OutlinePoint> points;
  };
  const Shape shapes[] = {{"bar", {kBar, 4}},
                          {"disc", {kDisc, 13}},
                          {"ell", {kEll, 6}},
                          {"frame", {kFrame, 12}},
                          {"leaf", {kLeaf, 4}}};
  bool written = true;
  uint8_t number = 0;
  for (const Shape& shape : shapes) {
    written &= write_outline_seeds(folder, shape.name, number, shape.points);
    number = static_cast<uint8_t>(number + 3);
  }
  return written;
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

// Choices that look random, then a font. Numbers are shifted by their first
// byte: `near` makes most of them small, so that things meet.
bool write_moving_seed(const std::string& path,
                       uint32_t number,
                       bool near,
                       const std::vector<uint8_t>& font) {
  constexpr size_t kChoices = 2500;
  std::vector<uint8_t> seed(2 + kChoices);
  put_u16(seed.data(), kChoices);
  Random random(number);
  for (size_t i = 2; i < seed.size(); ++i) {
    const uint32_t value = random.next() >> 24;
    seed[i] = static_cast<uint8_t>(near ? value % 32 : value);
  }
  seed[2] = 0;
  seed.insert(seed.end(), font.begin(), font.end());
  return write_file(path, seed);
}

std::vector<uint8_t> sample_font() {
  std::vector<uint8_t> font(outline_record::kSampleFontBytes);
  font.resize(outline_record::build_sample_font({font.data(), font.size()}));
  return font;
}

// A bar that becomes an L, and a bar that becomes a frame, its second master:
// its hole is born at a point. Numbers of points are as docs/FORMAT.md counts
// them.
std::vector<uint8_t> morphing_font() {
  using namespace outline_record;
  uint8_t morphs[8 + 2 * 2 + 2 * 16] = {2, 0, 4,          8, 80,         0,
                                        3, 0, 1 | 2 << 4, 0, 1 | 3 << 4, 16};
  BitWriter first({morphs + 12, 16});
  const auto put_stop = [](BitWriter& bits, uint32_t point, uint32_t part) {
    bits.put(point, 4);
    bits.put(part, 3);
  };
  first.put(4, 4);
  first.put(1, 2);
  first.put(6, 7);
  put_stop(first, 1, 0);
  put_stop(first, 1, 0);
  first.put(0, 2);
  first.put(6, 3);  // an 8th of the side
  first.put(1, 3);
  first.put(0, 1);
  first.put(2, 2);  // stays
  BitWriter second({morphs + 28, 16});
  second.put(4, 4);
  second.put(1, 2);
  second.put(4, 7);
  put_stop(second, 1, 0);
  put_stop(second, 1, 0);
  second.put(0, 8);
  second.put(2, 2);
  second.put(4, 7);
  put_stop(second, 1, 4);
  put_stop(second, 3, 4);
  second.put(6, 4);
  second.put(1, 3);
  put_stop(second, 6, 0);
  const OutlineSource glyphs[] = {{600, {kBar, 4}},
                                  {600, {kBar, 4}},
                                  {600, {kEll, 6}},
                                  {860, {kFrame, 12}}};
  std::vector<uint8_t> font(outline_record::kSampleFontBytes);
  font.resize(build_outline_font({glyphs, 4}, 0, 'A',
                                 {font.data(), font.size()}, {}, morphs));
  return font;
}

// A strike of the sample font, of noise with rows that repeat; then the choice
// of fuzz_strike.
bool write_strike_seed(const std::string& path,
                       const strike_font::StrikeSpec& spec) {
  static strike_font::StrikeWriter<4096> strikes;
  Random random(spec.bits);
  strikes.begin(1);
  strikes.add(spec, [&](uint16_t glyph, strike_font::Values& values) {
    values.left = -2;
    values.top = -8;
    values.width = 4 * glyph;
    values.height = glyph == 0 ? 0 : 9;
    for (int32_t y = 0; y < values.height; ++y) {
      for (int32_t x = 0; x < values.width; ++x) {
        values.at[y][x] =
            y % 3 == 2 ? values.at[y - 1][x]
                       : static_cast<uint8_t>(random.below(1u << spec.bits));
      }
    }
  });
  const Span<const uint8_t> section = strikes.bytes();
  std::vector<uint8_t> seed(section.begin(), section.end());
  // 12 px, of a strike beside outlines fitted; glyph 5, within the picture, and
  // its box for strikes alone.
  for (const int byte : {1, 1, 5, 0, 16, 0, 0, 0, 1, 0, 0, 0, 4, 254, 20, 9}) {
    seed.push_back(static_cast<uint8_t>(byte));
  }
  return write_file(path, seed);
}

bool write_strike_seeds(const std::string& folder) {
  using inkcell::format::StrikeFit;
  return write_strike_seed(folder + "bits.seed",
                           {12, 1, StrikeFit::source, 0, 8}) &&
         write_strike_seed(folder + "two_bits.seed",
                           {12, 2, StrikeFit::none, 0, 8, 300}) &&
         write_strike_seed(folder + "four_bits.seed",
                           {12, 4, StrikeFit::both, 0, 8, 0, 0xdeadbeef});
}

// Files with each map of characters and each kerning, and a choice.
bool write_truetype_seeds(const std::string& folder) {
  bool written = true;
  for (uint8_t i = 0; i < 4; ++i) {
    constexpr int32_t kFormats[] = {4, 12, 6, 0};
    sfnt_font::Options options;
    options.cmap_format = kFormats[i];
    options.gpos_format = i % 3;
    options.is_extension = i == 2;
    options.is_glyf_last = i == 1;
    std::vector<uint8_t> file(4096);
    file.resize(sfnt_font::build({file.data(), file.size()}, options));
    const int32_t choice[] = {
        2 * i + i / 2, 200, 20,   0, 12, 0, 0, 4, 0, 0, 1, 0, 0,
        'A' + i,       0,   8 + i};
    for (const int32_t value : choice) {
      file.push_back(static_cast<uint8_t>(value));
    }
    written &= write_file(
        folder + "cmap_" + std::to_string(kFormats[i]) + ".seed", file);
  }
  return written;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 6) {
    fprintf(stderr,
            "usage: fuzz_make_seeds FOLDER FOLDER_OF_OUTLINES "
            "FOLDER_OF_MOTION FOLDER_OF_STRIKES FOLDER_OF_TRUETYPE\n");
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
  GridRecord hints;
  hints.make_usual(2);
  spec.hints = hints.write().section;
  written &= write_seed(folder + "hints.seed", spec);
  GridRecord of_outlines;
  of_outlines.make_usual(8);
  std::vector<uint8_t> hinted(2 * outline_record::kSampleFontBytes);
  hinted.resize(outline_record::build_sample_font(
      {hinted.data(), hinted.size()}, of_outlines.write()));
  written &= write_file(folder + "hinted_outlines.seed", hinted);
  written &= write_all_outline_seeds(std::string(argv[2]) + "/");
  const std::string moving = std::string(argv[3]) + "/";
  written &= write_moving_seed(moving + "far.seed", 1, false, sample_font());
  written &=
      write_moving_seed(moving + "far_again.seed", 2, false, sample_font());
  written &= write_moving_seed(moving + "near.seed", 3, true, sample_font());
  written &=
      write_moving_seed(moving + "near_again.seed", 4, true, sample_font());
  written &= write_moving_seed(moving + "morph.seed", 5, true, morphing_font());
  written &=
      write_moving_seed(moving + "morph_far.seed", 6, false, morphing_font());
  written &= write_strike_seeds(std::string(argv[4]) + "/");
  written &= write_truetype_seeds(std::string(argv[5]) + "/");
  return written ? 0 : 1;
}
