// Hints for grid fitting: read as they were written, and any bytes.
#include "check.hpp"
#include "grid_record.hpp"
#include "inkcell/grid_hints.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace outline_record;

alignas(4) uint8_t rom[1024];

constexpr OutlinePoint kBox[] = {
    {start, 60, 0}, {corner, 540, 0}, {corner, 540, 512}, {corner, 60, 512}};

Font open(const Hints& hints) {
  const OutlineSource glyphs[] = {{600}, {600, {kBox, 4}}, {300, {kBox, 4}}};
  const size_t size =
      build_outline_font({glyphs, 3}, 0, 'A', {rom, sizeof rom}, hints);
  Font font;
  CHECK_OK(Font::open({rom, size}, font));
  return font;
}

void fill(GridRecord& record) {
  record.flags = 1;
  record.usual_zones();
  record.glyph_without_hints();
  record.insets_glyph(5, 2, 24, 126);
  record.stroke_in_zone(1, false, 0, 36);
  record.stroke(0, 200);
  record.end(330, true);
  record.stroke_in_zone(0, true, 1);
  record.edge(2, true);
  record.stem(-512, 254);
  record.stem(450);
  record.glyph(true, 0, 0);
}

}  // namespace

TEST(hints_read_as_they_were_written) {
  GridRecord record;
  fill(record);
  const Font font = open(record.write());
  CHECK_OK(font.verify());
  GridHints hints;
  CHECK_OK(GridHints::open(font, hints));
  CHECK(!hints.empty() && hints.has_contrast() && !hints.has_few_bars());
  CHECK_EQ(hints.zone_count(), 3);
  CHECK_EQ(hints.x_zone(), 1);
  CHECK_EQ(hints.zone(0).flat_u, 0);
  CHECK_EQ(hints.zone(0).overshoot_u, -14);
  CHECK(!hints.zone(0).is_top && hints.zone(2).is_top);
  CHECK_EQ(hints.stem_width_u(), 90);
  CHECK_EQ(hints.bar_width_u(), 70);
  // Without a record, and without a glyph.
  constexpr uint16_t kNone[] = {0, 3};
  for (const uint16_t none : kNone) {
    const GlyphHints empty(hints, font.record(none));
    CHECK(empty.y_count() == 0 && empty.x_count() == 0);
    CHECK_EQ(empty.bits(), 0);
  }
  const GlyphHints last_glyph(hints, font.record(2));
  CHECK(last_glyph.is_symmetric());
  CHECK_EQ(last_glyph.y_count(), 0);

  GlyphHints glyph(hints, font.record(1));
  CHECK(!glyph.is_symmetric());
  CHECK_EQ(glyph.left_inset_u(), 24);
  CHECK_EQ(glyph.right_inset_u(), 126);
  CHECK_EQ(glyph.y_count(), 5);
  CHECK_EQ(glyph.x_count(), 2);
  const YHint serif = glyph.next_y();
  CHECK(serif.kind == YHint::serif && !serif.is_top && serif.zone == 0);
  CHECK(serif.low_u == 0 && serif.high_u == 36 && !serif.is_standard);
  const YHint middle = glyph.next_y();
  CHECK(middle.kind == YHint::bar && middle.zone == YHint::kNoZone);
  CHECK(middle.low_u == 200 && middle.high_u == 270 && middle.is_standard);
  const YHint end = glyph.next_y();
  CHECK(end.kind == YHint::end && end.is_top && end.low_u == 330);
  const YHint top = glyph.next_y();
  CHECK(top.is_top && top.zone == 1 && top.low_u == 442 && top.high_u == 512);
  const YHint edge = glyph.next_y();
  CHECK(edge.kind == YHint::edge && edge.is_round && edge.zone == 2);
  CHECK(edge.low_u == 734 && edge.high_u == 734);
  const XHint first = glyph.next_x();
  CHECK(first.left_u == -512 && first.right_u == -258 && !first.is_standard);
  const XHint last = glyph.next_x();
  CHECK(last.left_u == 450 && last.right_u == 540 && last.is_standard);
}

TEST(tables_that_do_not_fit_are_corrupt) {
  GridRecord record;
  fill(record);
  Hints written = record.write();
  // The header, three zones and six tables of a word.
  constexpr size_t kTables = 8 + 12 + 12;
  CHECK_EQ(written.section.size, kTables);
  for (size_t size = 1; size <= kTables; ++size) {
    written.section.size = size;
    const Font font = open(written);
    GridHints hints;
    const Status expected = size < kTables ? Status::corrupt : Status::ok;
    CHECK_EQ(GridHints::open(font, hints), expected);
    CHECK_EQ(font.verify(), expected);
  }
}

TEST(verify_finds_what_does_not_ascend_or_exist) {
  for (int wrong = 0; wrong < 6; ++wrong) {
    GridRecord record;
    record.usual_zones();
    record.x_zone = wrong == 4 ? 3 : 255;
    record.glyph_without_hints();
    record.glyph(false, 2, 2);
    record.stroke(0, 200);
    record.stroke(0, wrong == 1 ? 198 : 200);
    record.stem(60);
    record.stem(wrong == 2 ? 150 : 152);
    record.glyph(false, wrong == 5 ? 3 : 1, 0);
    record.edge(wrong == 3 ? 3 : 2, false);
    CHECK_EQ(open(record.write()).verify(),
             wrong == 0 ? Status::ok : Status::corrupt);
  }
}

// Words of a table of two: 0 stands for 1, 01 for 2 and 3, 11 for 512 and more.
TEST(code_words_are_read_and_checked) {
  GridRecord record;
  record.usual_zones();
  Hints written = record.write();
  uint8_t section[8 + 12 + 48];
  for (size_t i = 0; i < 20; ++i) {
    section[i] = written.section[i];
  }
  section[5] = 2;  // code_bits
  section[6] = 128;
  const uint16_t entries[] = {1 | 1 << 7, 2 | 1 << 3 | 2 << 7, 1 | 1 << 7,
                              2 | 4 << 3 | 511 << 7};
  for (size_t i = 0; i < 24; ++i) {
    // Heads: a height, and nothing else.
    const auto entry =
        static_cast<uint16_t>(i < 4 ? 1 << 3 << 7 : entries[i % 4]);
    font_builder::put_u16(section + 20 + 2 * i, entry);
  }
  // A height of the word 01, 2 + 1: an edge of zone 0, round.
  const uint8_t zone_bits[] = {0b101};
  const HintBits glyphs[] = {{zone_bits, 0}, {zone_bits, 3}, {zone_bits, 3}};
  const Font font = open({{section, sizeof section}, {glyphs, 3}});
  CHECK_OK(font.verify());
  GridHints hints;
  CHECK_OK(GridHints::open(font, hints));
  GlyphHints glyph(hints, font.record(1));
  CHECK_EQ(glyph.y_count(), 1);
  const YHint bar = glyph.next_y();
  // Its width is the next word: 0, for 1.
  CHECK(bar.kind == YHint::bar && bar.zone == 0 && bar.is_round);
  CHECK_EQ(bar.low_u, -14);
  CHECK_EQ(bar.high_u, bar.low_u + 2);
  // An entry of a word that differs from the others.
  section[20 + 2 * (4 + 2)] ^= 0x80;
  CHECK_EQ(open({{section, sizeof section}, {glyphs, 3}}).verify(),
           Status::corrupt);
}

TEST(any_bytes_are_safe) {
  static uint8_t section[96];
  static uint8_t bytes[96];
  for (Random& random : Rounds(17, INKCELL_BOARD_FIRMWARE ? 40 : 2000)) {
    for (size_t i = 0; i < sizeof section; ++i) {
      section[i] = static_cast<uint8_t>(random.below(256));
      bytes[i] = static_cast<uint8_t>(random.below(256));
    }
    section[0] = static_cast<uint8_t>(random.below(10));
    section[5] = static_cast<uint8_t>(random.below(4));
    const HintBits glyph = {bytes, random.below(8 * sizeof bytes)};
    const HintBits glyphs[] = {glyph, glyph, glyph};
    const Font font =
        open({{section, random.below(sizeof section) + 1u}, {glyphs, 3}});
    static_cast<void>(font.verify());
    GridHints hints;
    if (GridHints::open(font, hints) != Status::ok) {
      continue;
    }
    for (uint16_t i = 0; i < 4; ++i) {
      GlyphHints read(hints, font.record(i));
      for (uint32_t k = 0; k < read.y_count(); ++k) {
        const YHint hint = read.next_y();
        CHECK(hint.low_u >= -2500 && hint.high_u <= 2500 &&
              hint.low_u <= hint.high_u);
      }
      for (uint32_t k = 0; k < read.x_count(); ++k) {
        const XHint hint = read.next_x();
        CHECK(hint.left_u >= -512 && hint.right_u <= 1800);
      }
    }
  }
}
