// Font::verify of fonts of outlines: rules 16 to 18 of docs/FORMAT.md.
#include "check.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/font.hpp"
#include "outline_record.hpp"

namespace {

using namespace inkcell;
using namespace font_builder;
using outline_record::BitWriter;
using outline_record::kCodeBits;
namespace header = format::header;
namespace section = format::section;
namespace word = format::outline;

alignas(4) uint8_t rom[outline_record::kSampleFontBytes];
size_t rom_bytes = 0;

Font sample() {
  Font font;
  rom_bytes = outline_record::build_sample_font(rom);
  CHECK_OK(open_any_font({rom, rom_bytes}, font));
  return font;
}

uint8_t* code_of(const Font& font) {
  return rom + (font.section(section::kCode).data - rom);
}
uint8_t* record_of(const Font& font, uint16_t glyph) {
  return rom + (font.record(glyph).data - rom);
}

// What verify says of the changed font; its checksums are made right first.
Status verify_changed() {
  CHECK(repair_checksums({rom, rom_bytes}));
  Font font;
  const Status status = open_any_font({rom, rom_bytes}, font);
  return status == Status::ok ? font.verify() : status;
}

Status verify_entry(uint32_t i, uint32_t value) {
  const Font font = sample();
  put_u16(code_of(font) + 2 * i, value);
  return verify_changed();
}

constexpr uint16_t kAbsent = 8;  // glyphs are 0 to 7
constexpr uint16_t kDisc = 1;
constexpr uint16_t kEll = 3;
constexpr uint16_t kComposite = 6;
constexpr uint16_t kEmpty = 7;

// The first number of a composite's record.
Status verify_component(uint16_t glyph) {
  const Font font = sample();
  uint8_t* const record = record_of(font, kComposite);
  record[1] = static_cast<uint8_t>(glyph >> 8);
  record[2] = static_cast<uint8_t>(glyph);
  return verify_changed();
}

}  // namespace

TEST(accepts_the_sample) {
  CHECK_OK(sample().verify());
  CHECK_EQ(verify_changed(), Status::ok);
}

// Rule 16.
TEST(finds_wrong_numbers_of_the_header) {
  const struct {
    uint32_t at;
    int32_t value;
    bool is_ok;
  } cases[] = {{header::kGridShift, -5, false},
               {header::kGridShift, -4, true},
               {header::kGridShift, 3, true},
               {header::kGridShift, 4, false},
               {header::kCodeBits, 0, false},
               {header::kCodeBits, kCodeBits - 1, false},
               {header::kCodeBits, kCodeBits + 1, false},
               {header::kCodeBits, 8, false},
               {header::kCodeBits, 255, false}};
  for (const auto& c : cases) {
    sample();
    rom[c.at] = static_cast<uint8_t>(c.value);
    CHECK_EQ(verify_changed() == Status::ok, c.is_ok);
  }
}

// Fonts of outlines have no smaller em, which fonts of strikes have.
TEST(outlines_have_16_units_to_the_em) {
  for (const uint32_t em : each_of({4u, 15u, 16u})) {
    sample();
    font_builder::put_u16(rom + header::kUnitsPerEm, em);
    CHECK_EQ(verify_changed() == Status::ok, em == 16);
  }
}

TEST(finds_wrong_code_words) {
  // Entry 15 is the only one of its word of 4 bits.
  const Font font = sample();
  const uint32_t good = get_u16(code_of(font) + 2 * 15);
  const uint32_t widths = good & ~word::kLengthMask;
  CHECK_EQ(verify_entry(15, good), Status::ok);
  for (uint32_t length = 0; length < 8; ++length) {
    // The bit after 3 may be that of a number.
    CHECK_EQ(verify_entry(15, widths | length) == Status::ok,
             length == 3 || length == 4);
  }
  // There is one table.
  for (uint32_t bit = word::kTableShift; bit < 16; ++bit) {
    CHECK_EQ(verify_entry(15, good | 1u << bit), Status::corrupt);
  }
  // An end has no widths.
  const uint32_t end = word::kEndOfContour << word::kKindShift;
  CHECK_EQ(verify_entry(15, 4 | end), Status::ok);
  CHECK_EQ(verify_entry(15, 4 | end | 1u << word::kXBitsShift),
           Status::corrupt);
  CHECK_EQ(verify_entry(15, 4 | end | 1u << word::kYBitsShift),
           Status::corrupt);
}

TEST(finds_entries_of_a_word_that_differ) {
  // 0 to 3 are one word; of 4 and 5 and others of two entries, each may have
  // the first bit of a number for its last one.
  for (uint32_t i = 0; i < 4; ++i) {
    const Font font = sample();
    const uint32_t good = get_u16(code_of(font) + 2 * i);
    CHECK_EQ(verify_entry(i, good ^ 1u << word::kXBitsShift), Status::corrupt);
  }
}

// Rule 17.
TEST(finds_outlines_with_too_many_points) {
  sample();
  const uint32_t most = get_u16(rom + header::kMaxPoints);
  for (uint32_t limit = 0; limit < most + 3; ++limit) {
    sample();
    put_u16(rom + header::kMaxPoints, limit);
    CHECK_EQ(verify_changed() == Status::ok, limit >= most);
  }
}

// The first word of a glyph: behind the bit that says that it is an outline.
Status verify_first_word(uint32_t bits, uint32_t count) {
  const Font font = sample();
  uint8_t* const record = record_of(font, kEll);
  uint32_t first = uint32_t{record[0]} << 8 | record[1];
  const uint32_t shift = 15 - count;
  first &= ~(((1u << count) - 1) << shift);
  first |= bits << shift;
  record[0] = static_cast<uint8_t>(first >> 8);
  record[1] = static_cast<uint8_t>(first);
  return verify_changed();
}

TEST(finds_contours_that_begin_wrong) {
  CHECK_EQ(verify_first_word(0, 2), Status::ok);       // corner
  CHECK_EQ(verify_first_word(2, 3), Status::corrupt);  // off the curve
  CHECK_EQ(verify_first_word(3, 3), Status::corrupt);  // smooth
  CHECK_EQ(verify_first_word(4, 3), Status::corrupt);  // an end: no point
}

TEST(finds_outlines_without_an_end) {
  // With 0 as another corner, zeros behind a record are points.
  const Font font = sample();
  uint8_t* const record = record_of(font, kDisc);
  for (size_t i = 1; i < font.record(kDisc).size; ++i) {
    record[i] = 0;
  }
  CHECK_EQ(verify_changed(), Status::corrupt);
}

// Rule 18.
TEST(finds_wrong_components) {
  CHECK_EQ(verify_component(kDisc), Status::ok);
  CHECK_EQ(verify_component(kEll), Status::ok);
  CHECK_EQ(verify_component(kComposite), Status::corrupt);
  CHECK_EQ(verify_component(kEmpty), Status::corrupt);
  CHECK_EQ(verify_component(kAbsent), Status::corrupt);
  CHECK_EQ(verify_component(0xffff), Status::corrupt);
}

TEST(counts_the_points_of_all_components) {
  // The frame has 15, the leaf 5; max_points is 19 of the disc and the leaf.
  sample();
  CHECK_EQ(get_u16(rom + header::kMaxPoints), 19);
  CHECK_EQ(verify_component(4), Status::corrupt);
}
