// Fonts: what open refuses, and what a font then answers.
#include "inkcell/font.hpp"

#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/version.hpp"

namespace {

using namespace inkcell;
using namespace font_builder;
namespace header = format::header;
namespace section = format::section;

alignas(4) uint8_t rom[kSampleFontBytes + 4];
size_t rom_bytes = 0;

// A fresh sample font in `rom`, opened.
Font sample() {
  rom_bytes = build_sample_font({rom, kSampleFontBytes});
  Font font;
  CHECK(rom_bytes != 0);
  CHECK_OK(Font::open({rom, rom_bytes}, font));
  return font;
}

// What open says after the header or directory was changed.
Status reopen() {
  CHECK(repair_checksums({rom, rom_bytes}));
  Font font;
  const Status status = Font::open({rom, rom_bytes}, font);
  CHECK(status == Status::ok || font.glyph_count() == 0);  // out untouched
  return status;
}

uint8_t* entry_of(uint32_t tag) {
  uint8_t* entry = rom + header::kBytes;
  while (get_u32(entry + section::kTag) != tag) {
    entry += section::kBytes;
  }
  return entry;
}

// A font of two-byte kerning classes: `classes` on each side, two glyphs.
Status open_wide(uint16_t classes, Font& font) {
  static constexpr GlyphSpec kGlyphs[] = {{500, {}, nullptr, nullptr},
                                          {500, {}, nullptr, nullptr}};
  static uint16_t sides[2];
  static int16_t values[300];
  for (int16_t i = 0; i < classes; ++i) {
    values[i] = i;
  }
  sides[0] = 1;
  sides[1] = classes;
  FontSpec spec;
  spec.glyphs = {kGlyphs, 2};
  spec.kerning.left_classes = 1;
  spec.kerning.right_classes = classes;
  static constexpr uint16_t kLeft[] = {1, 0};
  spec.kerning.left = {kLeft, 2};
  spec.kerning.right = {sides, 2};
  spec.kerning.values = {values, classes};
  rom_bytes = build_font(spec, {rom, kSampleFontBytes});
  CHECK(rom_bytes != 0);
  return Font::open({rom, rom_bytes}, font);
}

}  // namespace

TEST(default_font_is_empty) {
  const Font font;
  uint16_t glyph = 7;
  GlyphMetrics metrics;
  GlyphField field;
  CHECK_EQ(font.glyph_count(), 0);
  CHECK_EQ(font.glyph_of('A', glyph), Status::no_glyph);
  CHECK_EQ(glyph, 0);
  CHECK_EQ(font.glyph_metrics(0, metrics), Status::no_glyph);
  CHECK_EQ(font.field(0, field), Status::no_glyph);
  CHECK_EQ(font.kerning(0, 0), 0);
  CHECK_EQ(font.record(0).size, 0);
  CHECK_EQ(font.name().size, 0);
  CHECK_EQ(font.metrics().units_per_em, 1000);
  CHECK_EQ(font.range().max_px, 0);
  CHECK_EQ(font.verify(), Status::corrupt);
}

TEST(opens_and_ignores_what_follows) {
  sample();
  Font font;
  CHECK_OK(Font::open({rom, rom_bytes + 3}, font));
  CHECK_EQ(font.rom().size, rom_bytes);
  CHECK_OK(font.verify());
}

TEST(refuses_other_files) {
  Font font;
  CHECK_EQ(Font::open({}, font), Status::bad_magic);
  sample();
  for (size_t size = 0; size < header::kBytes; ++size) {
    CHECK_EQ(Font::open({rom, size}, font), Status::bad_magic);
  }
  rom[0] ^= 1;
  CHECK_EQ(reopen(), Status::bad_magic);
}

TEST(refuses_misaligned_bytes) {
  sample();
  Font font;
  for (size_t shift = 1; shift < 4; ++shift) {
    CHECK_EQ(Font::open({rom + shift, rom_bytes}, font), Status::misaligned);
  }
}

TEST(refuses_other_versions) {
  for (int change = 0; change < 4; ++change) {
    sample();
    uint8_t& byte =
        rom[change < 2 ? header::kFormatMajor : header::kFormatMinor];
    byte = static_cast<uint8_t>(byte + (change % 2 != 0 ? 1 : -1));
    CHECK_EQ(reopen(), Status::bad_version);
  }
}

TEST(refuses_every_truncation) {
  sample();
  Font font;
  for (size_t size = header::kBytes; size < rom_bytes; ++size) {
    CHECK_EQ(Font::open({rom, size}, font), Status::corrupt);
  }
}

TEST(refuses_a_changed_header) {
  sample();
  const uint32_t end = get_u16(rom + header::kHeaderBytes);
  for (uint32_t i = 0; i < end; ++i) {
    if (i >= header::kHeaderCrc && i < header::kContentCrc) {
      continue;
    }
    rom[i] ^= 0x40;
    Font font;
    CHECK(Font::open({rom, rom_bytes}, font) != Status::ok);
    rom[i] ^= 0x40;
  }
  rom[header::kHeaderCrc] ^= 1;
  Font font;
  CHECK_EQ(Font::open({rom, rom_bytes}, font), Status::corrupt);
}

TEST(refuses_sizes_that_do_not_fit) {
  sample();
  put_u16(rom + header::kSectionCount, 33);
  put_u16(rom + header::kHeaderBytes, 64 + 33 * 16);
  CHECK_EQ(reopen(), Status::corrupt);
  sample();
  put_u16(rom + header::kHeaderBytes, 64 + 4 * 16);  // of five sections
  CHECK_EQ(reopen(), Status::corrupt);
  sample();
  put_u16(rom + header::kGlyphCount, 0);
  CHECK_EQ(reopen(), Status::corrupt);
  sample();
  put_u16(rom + header::kGlyphCount, 6);  // METR holds five
  CHECK_EQ(reopen(), Status::corrupt);
  const uint32_t wrong_units[] = {15, 16385, 65535, 0};
  for (const uint32_t units : wrong_units) {
    sample();
    put_u16(rom + header::kUnitsPerEm, units);
    CHECK_EQ(reopen(), Status::corrupt);
  }
}

TEST(refuses_sections_outside_the_font) {
  const uint32_t tags[] = {section::kCmap, section::kMetrics, section::kGlyphs,
                           section::kKerning, section::kName};
  for (const uint32_t tag : tags) {
    sample();
    put_u32(entry_of(tag) + section::kSize, 0xffffffffu);
    CHECK_EQ(reopen(), Status::corrupt);
    sample();
    put_u32(entry_of(tag) + section::kOffset, 0xfffffffcu);
    CHECK_EQ(reopen(), Status::corrupt);
    sample();
    put_u32(entry_of(tag) + section::kOffset,
            static_cast<uint32_t>(rom_bytes + 4) & ~3u);
    CHECK_EQ(reopen(), Status::corrupt);
    sample();
    entry_of(tag)[section::kOffset] ^= 2;  // misaligned
    CHECK_EQ(reopen(), Status::corrupt);
  }
}

TEST(refuses_small_tables) {
  const uint32_t tags[] = {section::kMetrics, section::kGlyphs,
                           section::kKerning};
  const uint32_t smallest[] = {5 * 10, 4 * 6, 4 + 10 + 12};
  for (int i = 0; i < 3; ++i) {
    sample();
    put_u32(entry_of(tags[i]) + section::kSize, smallest[i] - 1);
    CHECK_EQ(reopen(), Status::corrupt);
    put_u32(entry_of(tags[i]) + section::kSize, smallest[i]);
    CHECK_EQ(reopen(), Status::ok);
  }
  sample();
  put_u32(entry_of(section::kKerning) + section::kSize, 3);
  CHECK_EQ(reopen(), Status::corrupt);
}

TEST(refuses_what_it_cannot_read) {
  sample();
  rom[header::kCellKind] = static_cast<uint8_t>(format::CellKind::fields);
  CHECK_EQ(reopen(), Status::unsupported);
  sample();
  rom[header::kCoding] = static_cast<uint8_t>(format::Coding::packed);
  CHECK_EQ(reopen(), Status::unsupported);
  // A section that nobody knows is skipped unless it must be understood.
  sample();
  put_u32(entry_of(section::kName) + section::kTag,
          format::tag('X', 'Y', 'Z', 'W'));
  CHECK_EQ(reopen(), Status::ok);
  put_u32(entry_of(format::tag('X', 'Y', 'Z', 'W')) + section::kFlags,
          section::kMustUnderstand);
  CHECK_EQ(reopen(), Status::unsupported);
}

TEST(reports_what_the_header_says) {
  const Font font = sample();
  const FontMetrics metrics = font.metrics();
  CHECK_EQ(font.glyph_count(), 5);
  CHECK_EQ(font.units_per_em(), 1000);
  CHECK_EQ(metrics.units_per_em, 1000);
  CHECK_EQ(metrics.ascender, 800);
  CHECK_EQ(metrics.descender, -200);
  CHECK_EQ(metrics.line_gap, 90);
  CHECK_EQ(metrics.x_height, 500);
  CHECK_EQ(metrics.cap_height, 700);
  CHECK_EQ(metrics.x_min, 82);
  CHECK_EQ(metrics.y_min, 0);
  CHECK_EQ(metrics.x_max, 668);
  CHECK_EQ(metrics.y_max, 668);
  CHECK_EQ(font.range().min_px, 12);
  CHECK_EQ(font.range().max_px, 64);
  CHECK_EQ(font.range().band_u, 64);
  CHECK_EQ(font.range().tolerance, 16);
  CHECK_EQ(font.range().max_cells, Record::kMaxCells);
  CHECK_EQ(font.range().max_depth, 2);
  const Span<const char> name = font.name();
  CHECK_EQ(name.size, 14);
  CHECK(name.size == 14 && name[0] == 'I' && name[13] == 'e');
  CHECK_EQ(font.section(section::kCmap).size, 24);
  CHECK_EQ(font.section(format::tag('N', 'O', 'N', 'E')).size, 0);
}

TEST(finds_glyphs) {
  const Font font = sample();
  struct Case {
    uint32_t code_point;
    int glyph;  // -1: absent
  };
  const Case cases[] = {
      {0, -1},       {31, -1},       {' ', 1},       {33, -1},
      {'A' - 1, -1}, {'A', 2},       {'B', 3},       {'C', 4},
      {'D', -1},     {0xffff, -1},   {0x1f5ff, -1},  {0x1f600, 3},
      {0x1f601, -1}, {0x10ffff, -1}, {0x110000, -1}, {0xffffffff, -1}};
  for (const Case& c : cases) {
    uint16_t glyph = 99;
    const Status status = font.glyph_of(c.code_point, glyph);
    CHECK_EQ(status, c.glyph < 0 ? Status::no_glyph : Status::ok);
    CHECK_EQ(glyph, c.glyph < 0 ? 0 : c.glyph);
  }
}

// All numbers of ranges, so that every path of the search is taken.
TEST(finds_glyphs_among_any_number_of_ranges) {
  static constexpr GlyphSpec kGlyphs[40] = {};
  CmapEntry entries[13];
  for (uint16_t ranges = 0; ranges <= 13; ++ranges) {
    for (uint16_t i = 0; i < ranges; ++i) {
      // Three code points each, a gap of two, glyphs from the end.
      entries[i] = {100u + 5u * i, 2, static_cast<uint16_t>(37 - 3 * i)};
    }
    FontSpec spec;
    spec.cmap = {entries, ranges};
    spec.glyphs = {kGlyphs, 40};
    rom_bytes = build_font(spec, {rom, kSampleFontBytes});
    Font font;
    CHECK_OK(Font::open({rom, rom_bytes}, font));
    for (uint32_t code_point = 98; code_point < 170; ++code_point) {
      const uint32_t range = (code_point - 100) / 5;
      const uint32_t step = (code_point - 100) % 5;
      const bool known = code_point >= 100 && range < ranges && step < 3;
      uint16_t glyph = 0;
      CHECK_EQ(font.glyph_of(code_point, glyph),
               known ? Status::ok : Status::no_glyph);
      CHECK_EQ(glyph, known ? 37 - 3 * range + step : 0);
    }
  }
}

TEST(glyph_beyond_the_count_is_absent) {
  sample();
  uint8_t* cmap = rom + get_u32(entry_of(section::kCmap) + section::kOffset);
  put_u16(cmap + format::cmap::kExtra, 0xffff);  // ' ' and 65535 more
  put_u32(cmap + 8, 0x20000);                    // 'A' moves out of the way
  CHECK(repair_checksums({rom, rom_bytes}));
  Font font;
  CHECK_OK(Font::open({rom, rom_bytes}, font));
  uint16_t glyph = 0;
  CHECK_OK(font.glyph_of(' ' + 3, glyph));
  CHECK_EQ(glyph, 4);
  CHECK_EQ(font.glyph_of(' ' + 4, glyph), Status::no_glyph);
  CHECK_EQ(font.glyph_of(' ' + 0xffff, glyph), Status::no_glyph);
  CHECK_EQ(font.verify(), Status::corrupt);
}

TEST(measures_glyphs) {
  const Font font = sample();
  GlyphMetrics metrics;
  CHECK_OK(font.glyph_metrics(2, metrics));
  CHECK_EQ(metrics.advance, 750);
  CHECK_EQ(metrics.x_min, 82);
  CHECK_EQ(metrics.y_min, 82);
  CHECK_EQ(metrics.x_max, 668);
  CHECK_EQ(metrics.y_max, 668);
  CHECK_EQ(font.glyph_metrics(5, metrics), Status::no_glyph);
  CHECK_EQ(font.glyph_metrics(65535, metrics), Status::no_glyph);
  CHECK_EQ(metrics.advance, 750);  // untouched
}

TEST(kerns_pairs) {
  const Font font = sample();
  const int32_t expected[5][5] = {
      {}, {}, {0, 0, 0, -100, 0}, {0, 0, -50, 0, 25}, {}};
  for (uint16_t left = 0; left < 5; ++left) {
    for (uint16_t right = 0; right < 5; ++right) {
      CHECK_EQ(font.kerning(left, right), expected[left][right]);
    }
  }
  CHECK_EQ(font.kerning(5, 2), 0);
  CHECK_EQ(font.kerning(2, 5), 0);
  CHECK_EQ(font.kerning(65535, 65535), 0);
}

TEST(kerning_classes_take_one_byte_up_to_255) {
  const uint16_t counts[] = {1, 255, 256, 300};
  for (const uint16_t classes : counts) {
    Font font;
    CHECK_OK(open_wide(classes, font));
    CHECK_OK(font.verify());
    CHECK_EQ(font.kerning(0, 0), 0);  // class 1: value 0
    CHECK_EQ(font.kerning(0, 1), classes - 1);
    CHECK_EQ(font.kerning(1, 1), 0);  // class 0 on the left
  }
}

TEST(kerning_class_out_of_range_kerns_with_nothing) {
  sample();
  uint8_t* kerning =
      rom + get_u32(entry_of(section::kKerning) + section::kOffset);
  kerning[format::kerning::kBytes + 2] = 3;  // A on the left: of two classes
  CHECK(repair_checksums({rom, rom_bytes}));
  Font font;
  CHECK_OK(Font::open({rom, rom_bytes}, font));
  CHECK_EQ(font.kerning(2, 3), 0);
  CHECK_EQ(font.kerning(3, 2), -50);
  CHECK_EQ(font.verify(), Status::corrupt);
}

TEST(opens_fields_by_glyph) {
  const Font font = sample();
  GlyphField field;
  CHECK_OK(font.field(2, field));
  CHECK_EQ(field.tiles_x, 4);
  CHECK_EQ(field.x0_u, -128);
  CHECK(field.cell_count > 0);
  CHECK_OK(font.field(1, field));  // the space
  CHECK_EQ(field.tiles_x, 0);
  CHECK_EQ(field.cell_count, 0);
  CHECK_EQ(font.field(5, field), Status::no_glyph);
  CHECK_EQ(font.record(1).size, 0);
  CHECK_EQ(font.record(5).size, 0);
}

TEST(wrong_glyph_offsets_give_no_record) {
  sample();
  const uint32_t glyphs =
      get_u32(entry_of(section::kGlyphs) + section::kOffset);
  const uint32_t size = get_u32(entry_of(section::kGlyphs) + section::kSize);
  uint8_t* offset = rom + glyphs + 4 * 2;
  const uint32_t original = get_u32(offset);
  const uint32_t wrong[] = {original + 1, original + 2, size + 4, 0xfffffffcu};
  for (const uint32_t value : wrong) {
    put_u32(offset, value);
    CHECK(repair_checksums({rom, rom_bytes}));
    Font font;
    CHECK_OK(Font::open({rom, rom_bytes}, font));
    CHECK_EQ(font.record(2).size, 0);
    GlyphField field;
    field.cell_count = 1;
    CHECK_OK(font.field(2, field));
    CHECK_EQ(field.cell_count, 0);
    CHECK_EQ(font.verify(), Status::corrupt);
  }
  put_u32(offset, original);
  const uint32_t end = get_u32(offset + 4);
  put_u32(offset + 4, size + 4);  // where the record ends
  Font longer;
  CHECK_OK(Font::open({rom, rom_bytes}, longer));
  CHECK_EQ(longer.record(2).size, 0);
  put_u32(offset + 4, end);
  put_u32(offset, original + 4);  // aligned, but starts amid the record
  CHECK(repair_checksums({rom, rom_bytes}));
  Font font;
  CHECK_OK(Font::open({rom, rom_bytes}, font));
  GlyphField field;
  CHECK(font.field(2, field) != Status::ok);
}
