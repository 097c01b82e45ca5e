// Fonts: what open refuses, and what a font then answers.
#include "inkcell/field/draw.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/font.hpp"

#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/version.hpp"
#include "sample_rom.hpp"

namespace {

using namespace sample_rom;

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
  return open_any_font({rom, rom_bytes}, font);
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
  CHECK_EQ(read_field(font, 0, field), Status::no_glyph);
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
  CHECK_OK(open_any_font({rom, rom_bytes + 3}, font));
  CHECK_EQ(font.rom().size, rom_bytes);
  CHECK_OK(font.verify());
}

TEST(refuses_other_files) {
  Font font;
  CHECK_EQ(open_any_font({}, font), Status::bad_magic);
  sample();
  for (size_t size = 0; size < header::kBytes; ++size) {
    CHECK_EQ(open_any_font({rom, size}, font), Status::bad_magic);
  }
  rom[0] ^= 1;
  CHECK_EQ(reopen(), Status::bad_magic);
}

TEST(refuses_misaligned_bytes) {
  sample();
  Font font;
  for (size_t shift = 1; shift < 4; ++shift) {
    CHECK_EQ(open_any_font({rom + shift, rom_bytes}, font), Status::misaligned);
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
    CHECK_EQ(open_any_font({rom, size}, font), Status::corrupt);
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
    CHECK(open_any_font({rom, rom_bytes}, font) != Status::ok);
    rom[i] ^= 0x40;
  }
  rom[header::kHeaderCrc] ^= 1;
  Font font;
  CHECK_EQ(open_any_font({rom, rom_bytes}, font), Status::corrupt);
}

TEST(refuses_sizes_that_do_not_fit) {
  sample();
  put_u16(rom + header::kSectionCount, 33);
  put_u16(rom + header::kHeaderBytes, header::kBytes + 33 * section::kBytes);
  CHECK_EQ(reopen(), Status::corrupt);
  sample();
  put_u16(rom + header::kHeaderBytes,  // of five sections
          header::kBytes + 4 * section::kBytes);
  CHECK_EQ(reopen(), Status::corrupt);
  sample();
  put_u16(rom + header::kGlyphCount, 0);
  CHECK_EQ(reopen(), Status::corrupt);
  sample();
  put_u16(rom + header::kGlyphCount, 6);  // METR holds five
  CHECK_EQ(reopen(), Status::corrupt);
  for (const uint32_t units : each_of({3u, 16385u, 65535u, 0u})) {
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
    sample();
    put_u32(entry_of(tag) + section::kOffset, 0);  // nothing lies before it
    CHECK_EQ(reopen(), Status::corrupt);
  }
}

TEST(refuses_small_tables) {
  const uint32_t tags[] = {section::kMetrics, section::kGlyphs};
  const uint32_t smallest[] = {17 + 5 * 10, 2 + 6 * 2};
  const uint32_t headers[] = {17, 2};
  for (int i = 0; i < 2; ++i) {
    sample();
    put_u32(entry_of(tags[i]) + section::kSize, smallest[i] - 1);
    CHECK_EQ(reopen(), Status::corrupt);
    put_u32(entry_of(tags[i]) + section::kSize, headers[i] - 1);
    CHECK_EQ(reopen(), Status::corrupt);
    put_u32(entry_of(tags[i]) + section::kSize, 0);
    CHECK_EQ(reopen(), Status::corrupt);
    put_u32(entry_of(tags[i]) + section::kSize, smallest[i]);
    CHECK_EQ(reopen(), Status::ok);
  }
  // Wider numbers need more room.
  sample();
  put_u32(entry_of(section::kMetrics) + section::kSize, smallest[0]);
  section_bytes(section::kMetrics)[format::metrics::kColumnBits] = 17;
  CHECK_EQ(reopen(), Status::corrupt);
  sample();
  put_u32(entry_of(section::kGlyphs) + section::kSize, smallest[1]);
  section_bytes(section::kGlyphs)[format::glyphs::kOffsetBits] = 17;
  CHECK_EQ(reopen(), Status::corrupt);
}

TEST(reads_numbers_that_are_too_wide_as_0) {
  sample();
  section_bytes(section::kMetrics)[format::metrics::kColumnBits] = 26;
  section_bytes(section::kGlyphs)[format::glyphs::kOffsetBits] = 26;
  for (const uint32_t tag : each_of({section::kMetrics, section::kGlyphs})) {
    put_u32(entry_of(tag) + section::kSize,
            static_cast<uint32_t>(rom + rom_bytes - section_bytes(tag)));
  }
  const Font font = reopened();
  GlyphMetrics metrics;
  CHECK_OK(font.glyph_metrics(2, metrics));
  CHECK_EQ(metrics.advance, 0);
  CHECK_EQ(font.record(2).size, 0);
  CHECK_EQ(font.verify(), Status::corrupt);
}

// Each count and width of KERN raised, until it does not fit.
TEST(kerning_that_does_not_fit_kerns_with_nothing) {
  const struct {
    uint32_t at;
    uint8_t value;
  } cases[] = {
      {format::kerning::kPairs, 4},
      {format::kerning::kPairs + 2, 0x40},  // 2^22 + 3
      {format::kerning::kPairs + 3, 0x20},  // 2^29 + 3, of 24 bits: wraps
      {format::kerning::kPairs + 3, 0xff},
      {format::kerning::kMembers, 6},
      {format::kerning::kMembers + 1, 0xff},
      {format::kerning::kLeftClasses, 3},
      {format::kerning::kLeftClasses + 1, 0xff},
      {format::kerning::kGlyphBits, 9},
      {format::kerning::kLeftBits, 255},
      {format::kerning::kRightBits, 9},
      {format::kerning::kValueBits, 255},
      {format::kerning::kStartBits, 17}};
  for (const auto& c : cases) {
    sample();
    section_bytes(section::kKerning)[c.at] = c.value;
    const Font font = reopened();
    CHECK_EQ(font.kerning(2, 3), 0);
    CHECK_EQ(font.kerning(3, 2), 0);
    CHECK_EQ(font.verify(), Status::corrupt);
  }
  const uint32_t size = 17 + 5 * 3 + 3 * 2 + 3 * 3;
  const uint32_t sizes[] = {size, size - 1, 17, 16, 1, 0};
  for (const uint32_t kept : sizes) {
    sample();
    put_u32(entry_of(section::kKerning) + section::kSize, kept);
    const Font font = reopened();
    CHECK_EQ(font.kerning(2, 3), kept == size ? -100 : 0);
    CHECK_EQ(font.verify(),
             kept == size || kept == 0 ? Status::ok : Status::corrupt);
  }
}

TEST(refuses_what_it_cannot_read) {
  sample();
  // The former coding `edges`; and a font of outlines without CODE is none.
  const Status expected[] = {Status::ok, Status::unsupported, Status::corrupt,
                             Status::unsupported};
  for (uint8_t coding = 0; coding < 4; ++coding) {
    rom[header::kCoding] = coding;
    CHECK_EQ(reopen(), expected[coding]);
  }
  // A section that nobody knows is skipped unless it must be understood.
  sample();
  put_u32(entry_of(section::kName) + section::kTag,
          format::tag('X', 'Y', 'Z', 'W'));
  CHECK_EQ(reopen(), Status::ok);
  entry_of(format::tag('X', 'Y', 'Z', 'W'))[section::kOffset] |=
      section::kMustUnderstand;
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
  const struct {
    uint32_t code_point;
    int glyph;  // -1: absent
  } cases[] = {{0, -1},       {31, -1},       {' ', 1},       {33, -1},
               {'A' - 1, -1}, {'A', 2},       {'B', 3},       {'C', 4},
               {'D', -1},     {0xffff, -1},   {0x1f5ff, -1},  {0x1f600, 3},
               {0x1f601, -1}, {0x10ffff, -1}, {0x110000, -1}, {0xffffffff, -1}};
  for (const auto& c : cases) {
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
    CHECK_OK(open_any_font({rom, rom_bytes}, font));
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
  uint8_t* cmap = section_bytes(section::kCmap);
  put_u16(cmap + format::cmap::kExtra, 0xffff);  // ' ' and 65535 more
  put_u32(cmap + 8, 0x20000);                    // 'A' moves out of the way
  const Font font = reopened();
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
  CHECK_EQ(font.advance(2), 750);
  CHECK_EQ(font.advance(5), 0);
  CHECK_EQ(Font().advance(0), 0);
}

// 82 and 668 of 1000 units are 83.97 and 684.03 u.
TEST(ink_boxes_hold_the_ink) {
  const Font font = sample();
  const InkBox ink = font.ink_box(2);
  CHECK(ink.x0_u <= 83 && ink.x0_u >= 82);
  CHECK(ink.y0_u <= 83 && ink.y0_u >= 82);
  CHECK(ink.x1_u >= 685 && ink.x1_u <= 686);
  CHECK(ink.y1_u >= 685 && ink.y1_u <= 686);
  CHECK_EQ(font.ink_box(5).x0_u, -InkBox::kFar);
  CHECK_EQ(font.ink_box(5).x1_u, InkBox::kFar);
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
    CHECK_EQ(font.kerning(0, 0), 0);  // class 1: no pair
    CHECK_EQ(font.kerning(0, 1), classes - 1);
    CHECK_EQ(font.kerning(1, 1), 0);  // class 0 on the left
  }
}

TEST(kerning_class_out_of_range_kerns_with_nothing) {
  sample();
  uint8_t* kerning = section_bytes(section::kKerning);
  kerning[format::kerning::kBytes + 3 * 2 + 1] = 3;  // A on the left: of two
  const Font font = reopened();
  CHECK_EQ(font.kerning(2, 3), 0);
  CHECK_EQ(font.kerning(3, 2), -50);
  CHECK_EQ(font.verify(), Status::corrupt);
}

TEST(opens_fields_by_glyph) {
  const Font font = sample();
  GlyphField field;
  CHECK_OK(read_field(font, 2, field));
  CHECK_EQ(field.tiles_x, 4);
  CHECK_EQ(field.x0_u, -128);
  CHECK(field.cell_count > 0);
  CHECK_OK(read_field(font, 1, field));  // the space
  CHECK_EQ(field.tiles_x, 0);
  CHECK_EQ(field.cell_count, 0);
  CHECK_EQ(read_field(font, 5, field), Status::no_glyph);
  CHECK_EQ(font.record(1).size, 0);
  CHECK_EQ(font.record(5).size, 0);
}

TEST(wrong_glyph_offsets_give_no_record) {
  sample();
  uint8_t* glyphs = section_bytes(section::kGlyphs);
  const uint32_t size = get_u32(entry_of(section::kGlyphs) + section::kSize);
  uint8_t* offset = glyphs + format::glyphs::kBytes + 2 * 2;  // of glyph 2
  const uint32_t original = get_u16(offset);
  const uint32_t end = get_u16(offset + 2);
  const auto open = [] {
    const Font font = reopened();
    return font;
  };
  const uint32_t wrong[] = {end + 1, size / 2 + 1, 0xffff};
  for (const uint32_t value : wrong) {
    put_u16(offset, value);
    const Font font = open();
    CHECK_EQ(font.record(2).size, 0);
    GlyphField field;
    field.cell_count = 1;
    CHECK_OK(read_field(font, 2, field));
    CHECK_EQ(field.cell_count, 0);
    CHECK_EQ(font.verify(), Status::corrupt);
  }
  put_u16(offset, original);
  put_u16(offset + 2, size / 2 + 1);  // where the record ends
  CHECK_EQ(open().record(2).size, 0);
  put_u16(offset + 2, end);
  CHECK_EQ(open().record(2).size, 2 * (end - original));
  put_u16(offset, original + 1);  // starts amid the record
  GlyphField field;
  CHECK(read_field(open(), 2, field) != Status::ok);
}

// Its numbers of 16 bits would be read across.
TEST(records_at_odd_places_are_not_read) {
  sample();
  uint8_t* glyphs = section_bytes(section::kGlyphs);
  glyphs[format::glyphs::kUnitLog2] = 0;
  uint8_t* offsets = glyphs + format::glyphs::kBytes;
  for (uint32_t i = 0; i <= 5; ++i) {
    put_u16(offsets + 2 * i, 2 * get_u16(offsets + 2 * i));
  }
  const Font font = reopened();
  CHECK_OK(font.verify());
  GlyphField field;
  CHECK_OK(read_field(font, 2, field));
  for (size_t i = rom_bytes - 1; i > 0; --i) {  // the records one byte on
    if (rom + i > font.record(2).data) {
      rom[i] = rom[i - 1];
    }
  }
  const uint32_t begin = get_u16(offsets + 4);
  put_u16(offsets + 4, begin + 1);
  CHECK(repair_checksums({rom, rom_bytes}));
  CHECK_EQ(read_field(font, 2, field), Status::corrupt);
  CHECK_EQ(font.verify(), Status::corrupt);
  put_u16(offsets + 6, get_u16(offsets + 6) + 1);  // as long as before
  CHECK_EQ(read_field(reopened(), 2, field), Status::corrupt);
}

// Up to the highest unit, in which all records of a small font begin together.
TEST(offsets_count_in_units) {
  static constexpr GlyphSpec kGlyphs[2] = {};
  FontSpec spec;
  spec.glyphs = {kGlyphs, 2};
  rom_bytes = build_font(spec, {rom, kSampleFontBytes});
  uint8_t* glyphs = section_bytes(section::kGlyphs);
  put_u32(rom + header::kTotalBytes, 4096);
  const uint32_t size = static_cast<uint32_t>(rom + 4096 - glyphs);
  put_u32(entry_of(section::kGlyphs) + section::kSize, size);
  for (uint8_t unit_log2 = 0; unit_log2 <= 7; ++unit_log2) {
    glyphs[format::glyphs::kUnitLog2] = unit_log2;
    put_u16(glyphs + 2, 8);
    put_u16(glyphs + 4, 9);
    put_u16(glyphs + 6, 11);
    CHECK(repair_checksums({rom, 4096}));
    Font font;
    CHECK_OK(open_any_font({rom, 4096}, font));
    CHECK(font.record(0).data == glyphs + (8 << unit_log2));
    CHECK_EQ(font.record(0).size, 1 << unit_log2);
    CHECK_EQ(font.record(1).size, 2 << unit_log2);
  }
}
