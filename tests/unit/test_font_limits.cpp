// Fonts at the limits of what their tables may hold, and just beyond them.
#include "check.hpp"
#include "font_builder.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "inkcell/font.hpp"
#include "inkcell/grid_hints.hpp"
#include "inkcell/text.hpp"
#include "sample_rom.hpp"

namespace {

using namespace sample_rom;

// The sample's METR has rows of five numbers of 16 bits: an advance and a box.
void put_box(uint32_t glyph, const int16_t (&box)[4]) {
  uint8_t* at =
      section_bytes(section::kMetrics) + format::metrics::kBytes + 10 * glyph;
  for (const int16_t side : box) {
    put_u16(at += 2, static_cast<uint16_t>(side));
  }
}

// KERN without members and pairs: widths, and starts of zeros.
uint8_t* memberless_kerning() {
  sample();
  uint8_t* const kerning = section_bytes(section::kKerning);
  put_u32(kerning + format::kerning::kPairs, 0);
  put_u16(kerning + format::kerning::kMembers, 0);
  put_u16(kerning + format::kerning::kLeftClasses, 0);
  for (uint32_t i = 0; i < 8; ++i) {
    kerning[format::kerning::kBytes + i] = 0;
  }
  return kerning;
}

}  // namespace

TEST(the_least_and_the_greatest_em_open) {
  sample();
  put_u16(rom + header::kUnitsPerEm, 4);
  CHECK_OK(reopen());
  put_u16(rom + header::kUnitsPerEm, 16384);
  CHECK_OK(reopen());
}

TEST(many_sections_open) {
  sample();
  constexpr uint32_t kMost = 32;
  const uint32_t count = get_u16(rom + header::kSectionCount);
  const uint32_t more = (kMost - count) * section::kBytes;
  const uint32_t end = header::kBytes + count * section::kBytes;
  for (size_t i = rom_bytes; i-- > end;) {
    rom[i + more] = rom[i];
  }
  for (uint32_t i = 0; i < kMost; ++i) {
    uint8_t* const entry = rom + header::kBytes + i * section::kBytes;
    if (i < count) {
      put_u32(entry + section::kOffset,
              get_u32(entry + section::kOffset) + more);
    } else {
      put_u32(entry + section::kTag,
              format::tag('X', 'X', 'A', static_cast<char>('A' + i)));
      put_u32(entry + section::kOffset, header::kBytes);
      put_u32(entry + section::kSize, 0);
    }
  }
  put_u16(rom + header::kSectionCount, kMost);
  put_u16(rom + header::kHeaderBytes, end + more);
  rom_bytes += more;
  put_u32(rom + header::kTotalBytes, static_cast<uint32_t>(rom_bytes));
  CHECK_OK(verify_changed());
}

TEST(an_empty_section_may_lie_at_the_end) {
  sample();
  rom_bytes = (rom_bytes + 3) / 4 * 4;
  put_u32(rom + header::kTotalBytes, static_cast<uint32_t>(rom_bytes));
  put_u32(entry_of(section::kName) + section::kOffset,
          static_cast<uint32_t>(rom_bytes));
  put_u32(entry_of(section::kName) + section::kSize, 0);
  CHECK_OK(reopen());
}

TEST(of_two_sections_with_a_tag_the_first_counts) {
  sample();
  put_u32(entry_of(section::kName) + section::kTag,
          section::kCmap);  // behind the real one
  const Font font = reopened();
  uint16_t glyph = 0;
  CHECK_OK(font.glyph_of('A', glyph));
  CHECK_EQ(glyph, 2);
  CHECK_EQ(font.section(section::kCmap).size, 24);
}

TEST(a_known_section_may_have_to_be_understood) {
  sample();
  entry_of(section::kName)[section::kOffset] |= section::kMustUnderstand;
  CHECK_OK(reopen());
}

TEST(fonts_without_tables_are_refused) {
  for (const uint32_t tag : each_of({section::kMetrics, section::kGlyphs})) {
    sample();
    uint8_t* entry = entry_of(tag);
    put_u32(entry + section::kOffset,
            get_u32(entry + section::kOffset) & ~section::kMustUnderstand);
    put_u32(entry + section::kTag, format::tag('X', 'Y', 'Z', 'W'));
    CHECK_EQ(reopen(), Status::corrupt);
  }
}

// Those of small ems, and of boxes that are larger than the type.
TEST(ink_boxes_end_far_away) {
  for (const uint32_t em : each_of({16u, 199u, 200u, 255u, 256u})) {
    sample();
    put_u16(rom + header::kUnitsPerEm, em);
    if (em == 256) {
      put_box(2, {-32768, -32768, 32767, 32767});
    }
    const InkBox ink = reopened().ink_box(2);
    CHECK_EQ(ink.x0_u, -InkBox::kFar);
    CHECK_EQ(ink.y0_u, -InkBox::kFar);
    CHECK_EQ(ink.x1_u, InkBox::kFar);
    CHECK_EQ(ink.y1_u, InkBox::kFar);
  }
}

// Whatever the em, above 0 and below: they hold the ink, and hardly more.
TEST(ink_boxes_are_tight) {
  for (const int32_t em : each_of({256, 257, 1000, 1024, 2047, 2048, 16384})) {
    for (const bool is_below : each_of({false, true})) {
      sample();
      put_u16(rom + header::kUnitsPerEm, static_cast<uint32_t>(em));
      if (is_below) {
        put_box(2, {-667, -207, -208, -1});
      }
      const Font font = reopened();
      const bool is_exact = (em & (em - 1)) == 0;
      for (uint16_t glyph = 0; glyph < font.glyph_count(); ++glyph) {
        GlyphMetrics metrics;
        CHECK_OK(font.glyph_metrics(glyph, metrics));
        const InkBox ink = font.ink_box(glyph);
        // How far outside, in u times the em.
        const int32_t outside[] = {metrics.x_min * 1024 - ink.x0_u * em,
                                   metrics.y_min * 1024 - ink.y0_u * em,
                                   ink.x1_u * em - metrics.x_max * 1024,
                                   ink.y1_u * em - metrics.y_max * 1024};
        for (const int32_t side : outside) {
          CHECK(side >= 0);
          CHECK(side < (is_exact ? em : 2 * em));
        }
      }
    }
  }
}

TEST(kerning_of_absent_glyphs_is_0) {
  sample();
  uint8_t* members = section_bytes(section::kKerning) + format::kerning::kBytes;
  members[3 * 4] = 5;      // of five glyphs
  members[3 * 4 + 1] = 2;  // like B on the left
  const Font font = reopened();
  CHECK_EQ(font.kerning(3, 2), -50);
  CHECK_EQ(font.kerning(5, 2), 0);
  CHECK_EQ(font.kerning(3, 5), 0);
}

TEST(left_class_0_kerns_with_nothing_whatever_the_starts) {
  sample();
  uint8_t* kerning = section_bytes(section::kKerning) + format::kerning::kBytes;
  kerning[3 * 4 + 1] = kerning[3 * 4 + 2] =
      0;  // what lies before the first start
  put_u16(kerning + 15, 1);
  const Font font = reopened();
  CHECK_EQ(font.kerning(1, 3), 0);
}

TEST(kerning_behind_the_last_row_is_not_read) {
  sample();
  uint8_t* kerning = section_bytes(section::kKerning) + format::kerning::kBytes;
  kerning[3 * 2 + 1] = 3;        // A: a left class of two
  put_u16(kerning + 15 + 4, 0);  // the last start
  const Font font = reopened();
  CHECK_EQ(font.kerning(2, 3), 0);
  CHECK_EQ(font.kerning(2, 4), 0);
}

TEST(rows_of_kerning_end_with_the_pairs) {
  sample();
  uint8_t* kerning = section_bytes(section::kKerning) + format::kerning::kBytes;
  put_u16(kerning + 15 + 4, 200);
  const Font font = reopened();
  CHECK_EQ(font.kerning(3, 2), -50);
}

TEST(log2_of_units_counts_modulo_8) {
  const size_t size = sample().record(2).size;
  section_bytes(section::kGlyphs)[format::glyphs::kUnitLog2] |= 8;
  const Font font = reopened();
  CHECK_EQ(font.record(2).size, size);
  CHECK_EQ(font.verify(), Status::corrupt);
}

TEST(a_part_of_a_cmap_entry_is_corrupt) {
  sample();
  put_u32(entry_of(section::kCmap) + section::kSize, 23);
  CHECK_EQ(verify_changed(), Status::corrupt);
}

TEST(ranges_that_overlap_are_corrupt) {
  sample();
  put_u32(section_bytes(section::kCmap) + 16, 'C');
  CHECK_EQ(verify_changed(), Status::corrupt);
  put_u32(section_bytes(section::kCmap) + 16, 'C' + 1);
  CHECK_OK(verify_changed());
}

TEST(numbers_of_kerning_have_limited_widths) {
  uint8_t* const kerning = memberless_kerning();
  kerning[format::kerning::kStartBits] = 25;
  CHECK_OK(verify_changed());
  kerning[format::kerning::kStartBits] = 26;
  CHECK_EQ(verify_changed(), Status::corrupt);
  kerning[format::kerning::kStartBits] = 25;
  kerning[format::kerning::kValueBits] = 17;
  CHECK_EQ(verify_changed(), Status::corrupt);
  kerning[format::kerning::kValueBits] = 16;
  CHECK_OK(verify_changed());
}

TEST(the_last_record_ends_in_the_section) {
  sample();
  uint8_t* glyphs = section_bytes(section::kGlyphs);
  const uint32_t size = get_u32(entry_of(section::kGlyphs) + section::kSize);
  put_u16(glyphs + 2 + 2 * 5, size / 2 + 1);
  CHECK_EQ(verify_changed(), Status::corrupt);
}

TEST(records_lie_behind_all_bits_of_the_offsets) {
  // Two glyphs without ink: three offsets of 9 bits are 27 bits, 4 bytes.
  static constexpr GlyphSpec kGlyphs[2] = {};
  FontSpec spec;
  spec.glyphs = {kGlyphs, 2};
  rom_bytes = build_font(spec, {rom, kSampleFontBytes});
  uint8_t* glyphs = section_bytes(section::kGlyphs);
  put_u32(entry_of(section::kGlyphs) + section::kSize, 8);  // 2 + 3 * 2
  glyphs[format::glyphs::kOffsetBits] = 9;
  glyphs[format::glyphs::kUnitLog2] = 0;
  for (uint32_t offset = 4; offset <= 8; ++offset) {
    put_u32(glyphs + 2, offset | offset << 9 | offset << 18);
    CHECK_EQ(verify_changed(), offset < 6 ? Status::corrupt : Status::ok);
  }
}

TEST(measures_one_glyph) {
  CHECK_EQ(measure(sample(), "A").y_min, 82);
  put_box(2, {-500, 82, -100, 668});
  const Font font = reopened();
  CHECK_EQ(measure(font, "A").x_min, -500);
  CHECK_EQ(measure(font, "A").x_max, -100);
}

TEST(lengths_in_px_are_clamped) {
  sample();
  put_u16(rom + header::kUnitsPerEm, 16);
  const Font font = reopened();
  Style style(kMaxSize, kFilterText);
  CHECK_EQ(to_px(font, style, 1 << 24).raw, INT32_MAX);
  CHECK_EQ(to_px(font, style, -(1 << 24)).raw, INT32_MIN);
}

TEST(nothing_is_no_record) {
  GlyphField field;
  CHECK_EQ(GlyphField::open({}, field), Status::corrupt);
}

TEST(tiles_are_2048_u_at_most) {
  alignas(2) uint8_t record[] = {1, 12, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0};
  GlyphField field;
  CHECK_EQ(GlyphField::open(record, field), Status::corrupt);
  record[1] = 11;
  CHECK_OK(GlyphField::open(record, field));
}

TEST(kerning_has_as_many_pairs_as_there_may_be) {
  sample();
  uint8_t* kerning = section_bytes(section::kKerning);
  put_u32(kerning + format::kerning::kPairs, format::kerning::kMaxPairs);
  kerning[format::kerning::kRightBits] = kerning[format::kerning::kValueBits] =
      0;
  put_u16(kerning + format::kerning::kValueBase, 7);
  // glyph, left class: rows of 16 bits
  for (uint32_t i = 0; i < 5; ++i) {
    kerning[17 + 2 * i] = static_cast<uint8_t>(i);
    kerning[18 + 2 * i] = 1;
  }
  put_u16(kerning + 27, 0);
  put_u16(kerning + 29, 1);
  put_u16(kerning + 31, 1);
  const Font font = reopened();
  CHECK_EQ(font.kerning(2, 3), 7);
  put_u32(kerning + format::kerning::kPairs, format::kerning::kMaxPairs + 1);
  CHECK_EQ(reopened().kerning(2, 3), 0);
}

TEST(rows_of_kerning_do_not_go_back) {
  static constexpr GlyphSpec kGlyphs[4] = {};
  static constexpr uint16_t kSides[] = {0, 1, 2, 3};
  static constexpr int16_t kValues[] = {10, 20, 30, 0, 0, 0, 0, 0, 0};
  FontSpec spec;
  spec.glyphs = {kGlyphs, 4};
  spec.kerning.left_classes = 3;
  spec.kerning.right_classes = 3;
  spec.kerning.left = {kSides, 4};
  spec.kerning.right = {kSides, 4};
  spec.kerning.values = {kValues, 9};
  rom_bytes = build_font(spec, {rom, kSampleFontBytes});
  CHECK_OK(verify_changed());
  uint8_t* kerning = section_bytes(section::kKerning);
  const uint32_t members = get_u16(kerning + format::kerning::kMembers);
  CHECK_EQ(get_u32(kerning + format::kerning::kPairs), 3);
  CHECK_EQ(kerning[format::kerning::kStartBits], 16);
  uint8_t* starts = kerning + 17 + 3 * members;
  CHECK_EQ(get_u16(starts + 2), 3);
  put_u16(starts + 2, 2);
  put_u16(starts + 4, 1);
  put_u16(starts + 6, 3);
  CHECK_EQ(verify_changed(), Status::corrupt);
  put_u16(starts + 2, 2);
  put_u16(starts + 4, 2);
  CHECK_OK(verify_changed());
}

TEST(the_first_row_of_kerning_starts_at_0) {
  uint8_t* const kerning = memberless_kerning();
  CHECK_OK(verify_changed());
  kerning[format::kerning::kBytes] = 1;
  CHECK_EQ(verify_changed(), Status::corrupt);
}

TEST(units_are_128_bytes_at_most) {
  static constexpr GlyphSpec kGlyphs[2] = {};
  FontSpec spec;
  spec.glyphs = {kGlyphs, 2};
  rom_bytes = build_font(spec, {rom, kSampleFontBytes});
  uint8_t* glyphs = section_bytes(section::kGlyphs);
  rom_bytes = 4096;
  put_u32(rom + header::kTotalBytes, 4096);
  put_u32(entry_of(section::kGlyphs) + section::kSize,
          static_cast<uint32_t>(rom + 4096 - glyphs));
  for (uint32_t i = 0; i < 3; ++i) {
    put_u16(glyphs + 2 + 2 * i, 8);
  }
  glyphs[format::glyphs::kUnitLog2] = 7;
  CHECK_OK(verify_changed());
  glyphs[format::glyphs::kUnitLog2] = 8;
  CHECK_EQ(verify_changed(), Status::corrupt);
}

// Sanitizers see who reads on.
TEST(tables_may_end_with_the_memory) {
  constexpr uint32_t kTags[] = {section::kCmap,   section::kMetrics,
                                section::kGlyphs, section::kKerning,
                                section::kGrid,   section::kName};
  for (const uint32_t tag : kTags) {
    for (uint32_t size = 0; size <= 32; size += 4) {
      sample();
      const uint32_t begin = static_cast<uint32_t>(rom_bytes + 3) / 4 * 4;
      rom_bytes = begin + size;
      for (uint32_t i = begin; i < rom_bytes; ++i) {
        rom[i] = 0;
      }
      // The table instead of the name, and nothing instead of the table.
      uint8_t* const name = entry_of(section::kName);
      for (uint8_t* entry = rom + header::kBytes; entry != name;
           entry += section::kBytes) {
        if (get_u32(entry + section::kTag) == tag) {
          put_u32(entry + section::kTag, format::tag('X', 'X', 'X', 'X'));
          put_u32(entry + section::kOffset, 0);
          put_u32(entry + section::kSize, 0);
        }
      }
      put_u32(name + section::kTag, tag);
      put_u32(name + section::kOffset, begin);
      put_u32(name + section::kSize, size);
      put_u32(rom + header::kTotalBytes, begin + size);
      CHECK(repair_checksums({rom, rom_bytes}));
      uint8_t* const last = rom + sizeof rom - rom_bytes;
      for (size_t i = rom_bytes; i-- > 0;) {
        last[i] = rom[i];
      }
      Font font;
      if (open_any_font({last, rom_bytes}, font) != Status::ok) {
        continue;
      }
      GridHints hints;
      uint16_t glyph = 0;
      CHECK(GridHints::open(font, hints) == Status::ok ||
            (tag == section::kGrid && size != 0));
      CHECK(font.glyph_of('A', glyph) == Status::ok || tag == section::kCmap);
      CHECK(font.kerning(2, 3) != 0 || tag == section::kKerning);
      CHECK_EQ(font.name().size, tag == section::kName ? size : 0);
      CHECK(font.verify() == Status::ok || size != 0);
    }
  }
}

TEST(records_may_end_with_the_memory) {
  alignas(4) static uint8_t memory[24];
  constexpr uint8_t kHeads[][2] = {{1, 8}, {2, 8}, {2, 0x88}, {3, 8}};
  for (const auto& head : kHeads) {
    for (uint32_t size = 0; size <= sizeof memory; size += 2) {
      for (uint8_t& byte : memory) {
        byte = 0;
      }
      uint8_t* const record = memory + sizeof memory - size;
      if (size > 1) {
        record[0] = head[0];
        record[1] = head[1];
      }
      if (size > 7 && head[0] < 3) {
        record[6] = record[7] = 1;
      }
      GlyphField field;
      CHECK(GlyphField::open({record, size}, field) != Status::ok || size > 10);
    }
  }
}
