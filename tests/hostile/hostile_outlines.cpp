// Outlines that no generator writes: code tables, boxes, records, composites,
// sizes and places at their limits, drawn in every style.
//
// Fonts are in heap blocks of exactly their size, so that the sanitizers see a
// read of a single byte too much.
//
//   hostile_outlines numbers   code tables, boxes, units, grids, max_points
//   hostile_outlines records   records and composites
//   hostile_outlines places    good fonts: windows, workspaces, far origins
#include <stdio.h>

#include <memory>
#include <string>
#include <vector>

#include "exercise.hpp"
#include "font_builder.hpp"
#include "outline_pictures.hpp"
#include "outline_record.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;
using hostile::check_generated_field;
using hostile::check_outline;
using hostile::OutlineCut;
using hostile::OutlineLook;
using hostile::require;
using outline_record::BitWriter;
namespace word = format::outline;

using Bytes = std::vector<uint8_t>;

Span<const uint8_t> span_of(const Bytes& bytes) {
  return {bytes.data(), bytes.size()};
}

uint16_t entry(uint32_t length, uint32_t kind, uint32_t x, uint32_t y) {
  return static_cast<uint16_t>(length | kind << word::kKindShift |
                               x << word::kXBitsShift | y << word::kYBitsShift);
}

Bytes table_of(const std::vector<uint16_t>& entries) {
  Bytes bytes;
  for (const uint16_t value : entries) {
    bytes.push_back(static_cast<uint8_t>(value));
    bytes.push_back(static_cast<uint8_t>(value >> 8));
  }
  return bytes;
}

// One word of each kind, steps of 15 bits.
Bytes usual_table() {
  return table_of({entry(2, 3, 0, 0), entry(2, 0, 15, 15), entry(2, 1, 15, 15),
                   entry(2, 2, 15, 15)});
}

// The parts of a font; glyph 0 has no ink, 1 and 2 are outlines, 3 is a
// composite.
struct Recipe {
  Bytes table = usual_table();
  Bytes records[3];
  int16_t box[4] = {-200, -100, 900, 800};
  int16_t whole[4] = {-200, -100, 900, 800};
  uint16_t units_per_em = 1024;
  uint16_t max_points = 64;
  int8_t grid_shift = 0;
  uint8_t code_bits = 2;
};

struct RomFont {
  std::unique_ptr<uint8_t[]> block;
  Font font;

  explicit RomFont(const Bytes& bytes)
      : block(std::make_unique<uint8_t[]>(bytes.size())) {
    std::copy(bytes.begin(), bytes.end(), block.get());
    require(Font::open({block.get(), bytes.size()}, font) == Status::ok,
            "the font opens");
    static_cast<void>(font.verify() == Status::ok);
  }
};

Bytes build(const Recipe& recipe) {
  font_builder::GlyphSpec glyphs[4] = {};
  for (uint32_t i = 1; i < 4; ++i) {
    glyphs[i].advance = 700;
    for (uint32_t side = 0; side < 4; ++side) {
      glyphs[i].box[side] = i == 3 ? recipe.whole[side] : recipe.box[side];
    }
    glyphs[i].bytes = span_of(recipe.records[i - 1]);
  }
  font_builder::FontSpec spec;
  spec.units_per_em = recipe.units_per_em;
  spec.glyphs = glyphs;
  spec.outlines = {span_of(recipe.table), recipe.code_bits, recipe.grid_shift,
                   recipe.max_points};
  Bytes font(1 << 15);
  font.resize(font_builder::build_font(spec, {font.data(), font.size()}));
  require(!font.empty(), "the font fits its buffer");
  return font;
}

// Random but reproducible styles and places.
class Artist {
 public:
  explicit Artist(uint32_t seed) : random_(seed) {}

  void draw(const Font& font, uint16_t glyph, bool is_exact) {
    OutlineLook look;
    const int32_t sizes[] = {4 * 64,  9 * 64 + 13,  16 * 64,  33 * 64,
                             90 * 64, 300 * 64 + 1, 1024 * 64};
    look.size_q6 = sizes[random_.below(7)];
    look.filter = static_cast<uint8_t>(random_.below(hostile::kFilterCount));
    look.effect =
        random_.below(3) == 0
            ? static_cast<uint8_t>(random_.below(hostile::kEffectCount))
            : uint8_t{0};
    look.map = random_.below(2) == 0
                   ? uint8_t{0}
                   : static_cast<uint8_t>(random_.below(hostile::kMapCount));
    look.is_fitted = random_.below(4) == 0;
    const uint32_t bytes[] = {0, 1, 3, 927, 928, 929, 935, 1000, 2560};
    OutlineCut cut;
    cut.whole_bytes = bytes[random_.below(9)];
    cut.part_bytes = bytes[random_.below(9)];
    cut.odd = static_cast<uint8_t>(random_.below(4));
    cut.x_cut = random_.between(1, hostile::kPictureWidth);
    cut.y_cut = random_.between(1, hostile::kPictureHeight);
    // A part of the glyph is in the picture.
    cut.origin = {Q26_6::from_raw(random_.between(-look.size_q6, 29 * 64)),
                  Q26_6::from_raw(random_.between(0, 22 * 64 + look.size_q6))};
    if (random_.below(8) == 0) {
      const int32_t far = 30000;
      cut.x0 = random_.between(-far, far);
      cut.y0 = random_.between(-far, far);
      cut.origin.x.raw += cut.x0 * 64;
      cut.origin.y.raw += cut.y0 * 64;
    } else if (random_.below(16) == 0) {
      cut.origin.x.raw = static_cast<int32_t>(random_.next());
      cut.origin.y.raw = static_cast<int32_t>(random_.next());
    }
    check_outline(font, glyph, look, cut, is_exact);
    check_generated_field(font, glyph, look, cut);
    ++count_;
  }

  void draw_all(const Bytes& font, int32_t rounds, bool is_exact = false) {
    const RomFont rom(font);
    for (int32_t i = 0; i < rounds; ++i) {
      for (uint16_t glyph = 0; glyph <= rom.font.glyph_count(); ++glyph) {
        draw(rom.font, glyph, is_exact);
      }
    }
    ++fonts_;
  }

  void report(const char* what) {
    printf("%-12s %7d fonts %8d pictures\n", what, fonts_, count_);
    require(count_ != 0, "pictures were drawn");
  }

 private:
  Random random_;
  int32_t count_ = 0;
  int32_t fonts_ = 0;
};

// Random bytes after the bits that mark an outline or a composite.
Bytes any_record(Random& random, uint32_t size, uint8_t first) {
  Bytes record(size);
  for (uint8_t& byte : record) {
    byte = static_cast<uint8_t>(random.next() >> 24);
  }
  if (size != 0) {
    record[0] = static_cast<uint8_t>(
        first == word::kRecordBit ? record[0] | first : first);
  }
  return record;
}

Bytes any_composite(Random& random, uint32_t size) {
  Bytes record = any_record(random, size, format::composite::kType);
  if (size > 2 && random.below(4) != 0) {
    record[1] = 0;  // glyphs that exist, most of them
    record[2] = static_cast<uint8_t>(random.below(5));
  }
  return record;
}

void fill_records(Random& random, Recipe& recipe) {
  recipe.records[0] = any_record(random, random.below(90), word::kRecordBit);
  recipe.records[1] = any_record(random, random.below(30), word::kRecordBit);
  recipe.records[2] = any_composite(random, random.below(40));
}

// All lengths, kinds and widths; tables with one repeated entry, and random
// ones.
void draw_tables(Artist& artist, Random& random) {
  for (uint32_t bits = 1; bits <= word::kMaxCodeBits; ++bits) {
    for (int32_t i = 0; i < 40; ++i) {
      Recipe recipe;
      recipe.code_bits = static_cast<uint8_t>(bits);
      const auto tables = size_t{1} << i % 5;  // more than a reader takes, too
      std::vector<uint16_t> entries(tables << bits);
      const auto any = static_cast<uint16_t>(random.next() >> 16);
      for (uint16_t& value : entries) {
        value = i % 4 == 0 ? any : static_cast<uint16_t>(random.next() >> 16);
        if (i % 4 == 1) {
          value = static_cast<uint16_t>(value & ~word::kLengthMask);  // 0 bits
        } else if (i % 4 == 2) {
          value = static_cast<uint16_t>(value | 0x1fe0);  // 15 and 15 bits
        }
      }
      recipe.table = table_of(entries);
      fill_records(random, recipe);
      artist.draw_all(build(recipe), 6);
    }
  }
}

// Numbers of the header, and boxes, at their limits.
void draw_numbers(Artist& artist, Random& random) {
  const int16_t sides[] = {INT16_MIN, -16384, -1, 0, 1, 1024, INT16_MAX};
  const uint16_t units[] = {16, 17, 1000, 16384};
  const uint16_t points[] = {0, 1, 2, 65535};
  for (const uint16_t em : units) {
    for (const uint16_t most : points) {
      for (int8_t shift = word::kMinGridShift; shift <= word::kMaxGridShift;
           ++shift) {
        for (int32_t i = 0; i < 3; ++i) {
          Recipe recipe;
          recipe.units_per_em = em;
          recipe.max_points = most;
          recipe.grid_shift = shift;
          for (uint32_t side = 0; side < 4; ++side) {
            recipe.box[side] = sides[random.below(7)];
            recipe.whole[side] = sides[random.below(7)];
          }
          fill_records(random, recipe);
          artist.draw_all(build(recipe), 2);
        }
      }
    }
  }
}

// Records that end within a word, or never: zeros are points.
void draw_endless(Artist& artist, Random& random) {
  Recipe recipe;
  recipe.table = table_of({entry(2, 2, 0, 0), entry(2, 0, 15, 15),
                           entry(2, 1, 7, 4), entry(2, 3, 0, 0)});
  recipe.max_points = 65535;
  for (uint32_t size = 0; size < 24; ++size) {
    recipe.records[0] = any_record(random, size, word::kRecordBit);
    recipe.records[1] = Bytes(size, 0xff);  // contours without points
    recipe.records[2] = any_composite(random, size);
    artist.draw_all(build(recipe), 3);
  }
}

void put_component(BitWriter& bits,
                   uint32_t glyph,
                   int32_t step,
                   int32_t entry_q14,
                   bool more) {
  bits.put(glyph, 16);
  bits.put(1, 1);
  bits.put(15, 4);
  bits.put(static_cast<uint32_t>(step), 15);
  bits.put(static_cast<uint32_t>(-step), 15);
  for (int32_t i = 0; i < 4; ++i) {
    bits.put(static_cast<uint32_t>(i % 2 == 0 ? entry_q14 : -entry_q14), 16);
  }
  bits.put(more ? 1 : 0, 1);
}

// Composites of themselves, of composites, of glyphs that do not exist; moved
// and mapped to the limits of numbers; and more of them than there may be
// points.
void draw_composites(Artist& artist, Random& random) {
  const uint32_t glyphs[] = {0, 1, 2, 3, 4, 65535};
  const int32_t steps[] = {-16384, -1, 0, 16383};
  const int32_t entries[] = {INT16_MIN, -1, 0, 1, 16384, INT16_MAX};
  for (const uint32_t glyph : glyphs) {
    for (const int32_t step : steps) {
      for (const int32_t entry_q14 : entries) {
        Recipe recipe;
        fill_records(random, recipe);
        recipe.max_points = random.below(2) == 0 ? 5 : 400;
        Bytes record(96);
        BitWriter bits({record.data(), record.size()});
        bits.put(format::composite::kType, 8);
        put_component(bits, 1, 100, 12000, true);
        put_component(bits, glyph, step, entry_q14, true);
        put_component(bits, 2, -step, entry_q14, false);
        record.resize(bits.bytes());
        recipe.records[2] = record;
        artist.draw_all(build(recipe), 3);
        recipe.records[1] = record;  // composites of composites
        artist.draw_all(build(recipe), 1);
      }
    }
  }
  Recipe recipe;
  recipe.max_points = 65535;
  recipe.records[2] = Bytes(16000, 0);
  recipe.records[2][0] = format::composite::kType;
  for (size_t i = 1; i < recipe.records[2].size(); ++i) {
    recipe.records[2][i] = i % 3 == 0 ? 0x10 : 0x40;
  }
  fill_records(random, recipe);
  artist.draw_all(build(recipe), 10);
}

void draw_good(Artist& artist) {
  Bytes font(outline_record::kSampleFontBytes);
  font.resize(outline_record::build_sample_font({font.data(), font.size()}));
  artist.draw_all(font, 4000, true);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string part = argc == 2 ? argv[1] : "";
  Random random(3);
  Artist artist(5);
  if (part == "numbers") {
    draw_tables(artist, random);
    draw_numbers(artist, random);
  } else if (part == "records") {
    draw_endless(artist, random);
    draw_composites(artist, random);
  } else if (part == "places") {
    draw_good(artist);
  } else {
    fprintf(stderr, "usage: hostile_outlines numbers|records|places\n");
    return 2;
  }
  artist.report(part.c_str());
  return 0;
}
