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

Font open(Span<const uint8_t> hints) {
  const OutlineSource glyphs[] = {{600}, {600, {kBox, 4}}, {300}};
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
  record.insets_glyph(5, 3, 24, 126);
  record.stroke_in_zone(1, false, 0, 36);
  record.stroke(0, 200);
  record.end(330, true);
  record.stroke_in_zone(0, true, 1);
  record.edge(2, true);
  record.stem(-512, 254);
  record.foot(300);
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
  CHECK(GlyphHints(hints, 0).empty());
  CHECK(GlyphHints(hints, 3).empty());
  CHECK(GlyphHints(hints, 2).is_symmetric());
  CHECK_EQ(GlyphHints(hints, 2).y_count(), 0);

  GlyphHints glyph(hints, 1);
  CHECK(!glyph.is_symmetric());
  CHECK_EQ(glyph.left_inset_u(), 24);
  CHECK_EQ(glyph.right_inset_u(), 126);
  CHECK_EQ(glyph.y_count(), 5);
  CHECK_EQ(glyph.x_count(), 3);
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
  CHECK(first.left_u == -512 && first.right_u == -258 && !first.is_foot);
  const XHint foot = glyph.next_x();
  CHECK(foot.is_foot && foot.left_u == 300 && foot.right_u == 300);
  const XHint last = glyph.next_x();
  CHECK(last.left_u == 450 && last.right_u == 540 && last.is_standard);
}

TEST(tables_that_do_not_fit_are_corrupt) {
  GridRecord record;
  fill(record);
  const Span<const uint8_t> bytes = record.write();
  // The header, three zones and four offsets.
  constexpr size_t kTables = 8 + 12 + 4;
  for (size_t size = 1; size < bytes.size; ++size) {
    const Font font = open({bytes.data, size});
    GridHints hints;
    CHECK_EQ(GridHints::open(font, hints),
             size < kTables ? Status::corrupt : Status::ok);
    // Records that end beyond the section are none.
    CHECK(size < kTables || GlyphHints(hints, 2).empty());
    CHECK_EQ(font.verify(), Status::corrupt);
  }
}

TEST(verify_finds_what_does_not_ascend_or_exist) {
  for (int wrong = 0; wrong < 5; ++wrong) {
    GridRecord record;
    record.usual_zones();
    record.x_zone = wrong == 4 ? 3 : 255;
    record.glyph_without_hints();
    record.glyph(false, 2, 2);
    record.stroke(0, 200);
    record.stroke(0, wrong == 1 ? 198 : 200);
    record.stem(60);
    record.stem(wrong == 2 ? 150 : 152);
    record.glyph(false, 1, 0);
    record.edge(wrong == 3 ? 3 : 2, false);
    CHECK_EQ(open(record.write()).verify(),
             wrong == 0 ? Status::ok : Status::corrupt);
  }
}

TEST(any_bytes_are_safe) {
  static uint8_t bytes[96];
  for (Rounds rounds(17, INKCELL_BOARD_FIRMWARE ? 40 : 2000); rounds.next();) {
    Random& random = rounds.random;
    for (uint8_t& byte : bytes) {
      byte = static_cast<uint8_t>(random.below(256));
    }
    bytes[0] = static_cast<uint8_t>(random.below(10));
    bytes[5] = static_cast<uint8_t>(random.below(9));
    const Font font = open({bytes, random.below(sizeof bytes) + 1u});
    static_cast<void>(font.verify());
    GridHints hints;
    if (GridHints::open(font, hints) != Status::ok) {
      continue;
    }
    for (uint32_t glyph = 0; glyph < 4; ++glyph) {
      GlyphHints read(hints, glyph);
      for (uint32_t i = 0; i < read.y_count(); ++i) {
        const YHint hint = read.next_y();
        CHECK(hint.low_u >= -2500 && hint.high_u <= 2500 &&
              hint.low_u <= hint.high_u);
      }
      for (uint32_t i = 0; i < read.x_count(); ++i) {
        const XHint hint = read.next_x();
        CHECK(hint.left_u >= -512 && hint.right_u <= 1800);
      }
    }
  }
}
