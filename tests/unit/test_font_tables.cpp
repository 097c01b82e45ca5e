// Tables of fonts: code points on pages, and rows without advances.
#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/font.hpp"
#include "sample_rom.hpp"

using namespace sample_rom;

// Two pages, and one between them without characters.
TEST(code_points_are_found_on_pages) {
  uint8_t pages[6 + 8 + 4] = {0x4e, 0,  3, 0,  0, 0,    14,   0,    16,
                              0,    16, 0, 18, 0, 0x00, 0xff, 0x01, 0x42};
  put_u16(pages + format::code_pages::kGlyphBase, 0x10000 + 1 - 14);
  static constexpr GlyphSpec kGlyphs[5] = {};
  const CmapEntry cmap[] = {{'A', 0, 4}};
  FontSpec spec;
  spec.cmap = {cmap, 1};
  spec.glyphs = kGlyphs;
  spec.code_pages = pages;
  const auto build = [&spec](Font& font) {
    rom_bytes = build_font(spec, {rom, sizeof rom});
    CHECK_OK(open_any_font({rom, rom_bytes}, font));
  };
  Font font;
  build(font);
  CHECK_OK(font.verify());
  constexpr uint32_t kFound[] = {0x4e00, 0x4eff, 0x5001, 0x5042};
  uint16_t glyph = 9;
  for (uint16_t i = 0; i < 4; ++i) {
    CHECK_OK(font.glyph_of(kFound[i], glyph));
    CHECK_EQ(glyph, i + 1);
  }
  CHECK_OK(font.glyph_of('A', glyph));
  CHECK_EQ(glyph, 4);
  constexpr uint32_t kAbsent[] = {0,      0x4d00,   0x4dff, 0x4e01,    0x4f00,
                                  0x5000, 0x5100,   0x5101, 0x10ffff,  'B',
                                  0xff,   0x104e00, 0x1,    0xffffffff};
  for (const uint32_t absent : kAbsent) {
    glyph = 9;
    CHECK_EQ(font.glyph_of(absent, glyph), Status::no_glyph);
    CHECK_EQ(glyph, 0);
  }
  // Any size and any numbers are safe.
  for (size_t size = 1; size < sizeof pages; ++size) {
    spec.code_pages = {pages, size};
    build(font);
    CHECK_EQ(font.verify(), Status::corrupt);
    for (const uint32_t code_point : kFound) {
      static_cast<void>(font.glyph_of(code_point, glyph));
      CHECK(glyph < 5);
    }
  }
  spec.code_pages = pages;
  const struct {
    size_t at;
    uint8_t value;
  } kWrong[] = {{1, 0x11},               // a page behind the last one
                {2, 0},    {2, 4},       // pages
                {4, 0xf4}, {4, 0xf1},    // a glyph too many, and one below 0
                {6, 15},   {8, 13},      // starts
                {12, 17},  {12, 19},     // the end
                {15, 0},   {16, 0x42}};  // code points
  for (const auto& wrong : kWrong) {
    const uint8_t right = pages[wrong.at];
    pages[wrong.at] = wrong.value;
    build(font);
    CHECK_EQ(font.verify(), Status::corrupt);
    for (const uint32_t code_point : kFound) {
      static_cast<void>(font.glyph_of(code_point, glyph));
      CHECK(glyph < 5);
    }
    pages[wrong.at] = right;
  }
}

// Rows of five numbers of 16 bits: those of later glyphs have no advance.
TEST(advances_may_be_of_the_first_glyphs_only) {
  sample();
  uint8_t* const metrics = section_bytes(section::kMetrics);
  uint8_t* const rows = metrics + format::metrics::kBytes;
  put_u16(metrics, 25);
  put_u16(metrics + format::metrics::kAdvances, 2);
  uint8_t* to = rows + 20;
  for (uint32_t glyph = 2; glyph < 5; ++glyph) {
    for (uint32_t i = 2; i < 10; ++i) {
      *to++ = rows[10 * glyph + i];
    }
  }
  const Font font = reopened();
  CHECK_OK(font.verify());
  CHECK_EQ(font.advance(1), 325);
  CHECK_EQ(font.advance(2), 25);
  CHECK_EQ(font.advance(4), 25);
  GlyphMetrics read;
  CHECK_OK(font.glyph_metrics(2, read));
  CHECK(read.advance == 25 && read.x_min == 82 && read.y_max == 668);
  CHECK_OK(font.glyph_metrics(3, read));
  CHECK(read.advance == 25 && read.x_min == 121 && read.y_max == 629);
  CHECK_EQ(font.ink_box(3).x0_u, 123);
  put_u16(metrics + format::metrics::kAdvances, 6);  // of five
  CHECK_EQ(reopen(), Status::corrupt);
}
