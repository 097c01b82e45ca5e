// Font::verify: everything that open leaves to the moment of reading.
#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/verify.hpp"
#include "inkcell/font.hpp"
#include "sample_rom.hpp"

namespace {

using namespace sample_rom;

uint8_t* bytes_of(const Font& font, uint32_t tag) {
  return rom + (font.section(tag).data - rom);
}

uint8_t* record_of(const Font& font, uint16_t glyph) {
  return rom + (font.record(glyph).data - rom);
}

// A reference of glyph 2: tile or child `index`.
uint8_t* reference_of(const Font& font, uint32_t index) {
  return record_of(font, 2) + format::glyph::kBytes + 2 * index;
}

}  // namespace

TEST(accepts_the_sample) {
  CHECK_OK(sample().verify());
  CHECK_EQ(verify_changed(), Status::ok);
}

TEST(finds_any_changed_byte) {
  const Font font = sample();
  const uint32_t begin = get_u16(rom + format::header::kHeaderBytes);
  for (size_t i = begin; i < rom_bytes; ++i) {
    rom[i] ^= 0x10;
    CHECK_EQ(font.verify(), Status::corrupt);
    rom[i] ^= 0x10;
    i += INKCELL_BOARD_FIRMWARE ? 60 : 0;
  }
  CHECK_OK(font.verify());
}

TEST(finds_wrong_code_points) {
  Font font = sample();
  uint8_t* cmap = bytes_of(font, section::kCmap);
  put_u32(cmap + 8, 0x20);  // 'A'.. now begins where ' ' does
  CHECK_EQ(verify_changed(), Status::corrupt);
  put_u32(cmap + 8, 0x21);  // right behind it
  CHECK_EQ(verify_changed(), Status::ok);
  font = sample();
  put_u32(cmap + 16, 0x110000);
  CHECK_EQ(verify_changed(), Status::corrupt);
  put_u32(cmap + 16, 0x10ffff);
  CHECK_EQ(verify_changed(), Status::ok);
  put_u16(cmap + 16 + format::cmap::kFirstGlyph, 5);  // of five
  CHECK_EQ(verify_changed(), Status::corrupt);
  font = sample();
  put_u16(cmap + 8 + format::cmap::kExtra, 3);  // A..D on glyphs 2..5
  CHECK_EQ(verify_changed(), Status::corrupt);
}

// Each number of KERN, set to what does not fit and to what does.
TEST(finds_wrong_kerning) {
  constexpr uint32_t kMembers = format::kerning::kBytes;  // glyph, left, right
  constexpr uint32_t kStarts = kMembers + 5 * 3;          // 0, 1, 3
  constexpr uint32_t kPairs = kStarts + 3 * 2;            // right class, value
  const struct {
    uint32_t at;
    uint8_t value;
    Status expected;
  } cases[] = {{kMembers + 3 * 2, 1, Status::corrupt},  // glyph 1 twice
               {kMembers + 3 * 4, 5, Status::corrupt},  // of five
               {kMembers + 3 * 2 + 1, 2, Status::ok},   // left class
               {kMembers + 3 * 2 + 1, 3, Status::corrupt},
               {kMembers + 3 * 2 + 2, 3, Status::ok},  // right class
               {kMembers + 3 * 2 + 2, 4, Status::corrupt},
               {kStarts, 1, Status::corrupt},
               {kStarts + 2, 0, Status::corrupt},  // 3, 1, 3 in one row
               {kStarts + 2, 4, Status::corrupt},
               {kStarts + 4, 2, Status::corrupt},  // a pair without row
               {kStarts + 4, 4, Status::corrupt},
               {kPairs, 0, Status::corrupt},
               {kPairs, 3, Status::ok},
               {kPairs, 4, Status::corrupt},
               {kPairs + 3, 3, Status::corrupt},  // the same twice in row 2
               {kPairs + 3, 2, Status::ok}};
  for (const auto& c : cases) {
    const Font font = sample();
    bytes_of(font, section::kKerning)[c.at] = c.value;
    CHECK_EQ(verify_changed(), c.expected);
  }
}

// One bit more than the widest, in sections that reach to the end of the font.
TEST(finds_numbers_that_are_too_wide) {
  const struct {
    uint32_t tag;
    uint32_t at;
    uint8_t value;
  } cases[] = {{section::kMetrics, format::metrics::kColumnBits, 17},
               {section::kMetrics, format::metrics::kColumnBits + 4, 17},
               {section::kKerning, format::kerning::kGlyphBits, 17},
               {section::kKerning, format::kerning::kLeftBits, 17},
               {section::kKerning, format::kerning::kRightBits, 17},
               {section::kKerning, format::kerning::kValueBits, 17},
               {section::kKerning, format::kerning::kStartBits, 26},
               {section::kGlyphs, format::glyphs::kOffsetBits, 26},
               {section::kGlyphs, format::glyphs::kUnitLog2, 8}};
  for (const auto& c : cases) {
    Font font = sample();
    uint8_t* const at = bytes_of(font, c.tag);
    uint8_t* entry = rom + format::header::kBytes;
    while (get_u32(entry + section::kTag) != c.tag) {
      entry += section::kBytes;
    }
    put_u32(entry + section::kSize,
            static_cast<uint32_t>(rom + rom_bytes - at));
    CHECK_OK(verify_changed());
    at[c.at] = c.value;
    CHECK_EQ(verify_changed(), Status::corrupt);
  }
}

TEST(finds_wrong_glyph_offsets) {
  const Font font = sample();
  uint8_t* offsets = bytes_of(font, section::kGlyphs) + format::glyphs::kBytes;
  const uint32_t second = get_u16(offsets + 4);
  const uint32_t wrong[] = {0, 6, get_u16(offsets + 6) + 1, 0xffff};
  for (const uint32_t value : wrong) {
    put_u16(offsets + 4, value);
    CHECK_EQ(verify_changed(), Status::corrupt);
  }
  put_u16(offsets + 4, second);
  CHECK_EQ(verify_changed(), Status::ok);
  // Also where equal offsets say that there is no record.
  const uint32_t size =
      static_cast<uint32_t>(font.section(section::kGlyphs).size);
  const struct {
    uint32_t offset;
    Status expected;
  } cases[] = {{6, Status::corrupt},  // amid the offsets
               {7, Status::ok},
               {size / 2, Status::ok},
               {size / 2 + 1, Status::corrupt}};
  for (const auto& c : cases) {
    for (uint32_t i = 0; i <= font.glyph_count(); ++i) {
      put_u16(offsets + 2 * i, c.offset);
    }
    CHECK_EQ(verify_changed(), c.expected);
  }
}

TEST(finds_trees_without_a_square_left_to_divide) {
  const Font font = sample();
  record_of(font, 2)[format::glyph::kTileLog2] = 0;
  CHECK_EQ(verify_changed(), Status::corrupt);
}

TEST(finds_wrong_records) {
  Font font = sample();
  record_of(font, 2)[format::glyph::kType] = 9;
  CHECK_EQ(verify_changed(), Status::unsupported);
  font = sample();
  put_u16(record_of(font, 2) + format::glyph::kCellCount, 999);
  CHECK_EQ(verify_changed(), Status::corrupt);
}

TEST(finds_wrong_references) {
  const uint16_t nodes = 40;
  const uint16_t cells = 88;
  // Children of node 1 are references 20 to 23.
  const struct {
    uint32_t index;
    uint32_t reference;
    Status expected;
  } cases[] = {
      {0, format::glyph::kInside, Status::ok},
      {0, format::glyph::kFirstNode + nodes - 1, Status::corrupt},  // not 1st
      {0, format::glyph::kFirstNode + nodes, Status::corrupt},
      {0, 0x7fff, Status::corrupt},
      {0, format::glyph::kCellFlag + cells - 1, Status::ok},
      {0, format::glyph::kCellFlag + cells, Status::corrupt},
      {0, 0xffff, Status::corrupt},
      {20, format::glyph::kFirstNode + 2, Status::corrupt},  // its second
      {20, format::glyph::kFirstNode + 1, Status::corrupt},  // itself
      {23, format::glyph::kFirstNode, Status::corrupt}};     // its parent
  for (const auto& c : cases) {
    const Font font = sample();
    CHECK_EQ(get_u16(record_of(font, 2) + format::glyph::kNodeCount), nodes);
    CHECK_EQ(get_u16(record_of(font, 2) + format::glyph::kCellCount), cells);
    put_u16(reference_of(font, c.index), c.reference);
    CHECK_EQ(verify_changed(), c.expected);
  }
}

// The font may lie in flash that is written while it is open.
TEST(survives_a_header_that_changes) {
  const Font font = sample();
  put_u16(rom + format::header::kHeaderBytes, 0xffff);
  CHECK_EQ(font.verify(), Status::corrupt);
  put_u16(rom + format::header::kHeaderBytes, 0);
  CHECK_EQ(font.verify(), Status::corrupt);
  put_u16(rom + format::header::kSectionCount, 0xffff);
  CHECK_EQ(font.section(format::tag('N', 'O', 'N', 'E')).size, 0);
  for (size_t i = 0; i < rom_bytes; ++i) {
    rom[i] = 0xff;
  }
  CHECK(font.verify() != Status::ok);
  CHECK_EQ(font.name().size, 0);
}
