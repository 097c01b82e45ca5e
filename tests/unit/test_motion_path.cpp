// Paths, and letters along them.
#include "inkcell/motion/path.hpp"

#include "check.hpp"
#include "inkcell/motion/run.hpp"
#include "outline_font.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;

const Font& font = outline_record::sample_font();

constexpr int32_t kOne = 1 << 16;

// Within 1/1000 px.
bool is_near(Q16_16 at, int32_t expected) {
  const int32_t off = at.raw - expected * kOne;
  return off <= 65 && off >= -65;
}

RunPlace place_at(int32_t x, int32_t y, int32_t size) {
  RunPlace where;
  where.origin = {x, y};
  where.size = Q26_6::from_int(size);
  return where;
}

RunGlyph run_glyphs[16];
PosedGlyph later[16];

}  // namespace

TEST(paths_are_as_long_as_they_look) {
  PathPoint points[80];
  Path path(points);
  CHECK_EQ(path.line_to({1, 1}), Status::bad_argument);
  CHECK_OK(path.move_to({10, 10}));
  CHECK_EQ(path.move_to({10, 10}), Status::bad_argument);
  CHECK_OK(path.line_to({40, 50}));
  CHECK_EQ(path.length().raw, 50 * kOne);
  const PathPoint fifth = path.at(Q16_16::from_int(10));
  CHECK(is_near(fifth.x, 16));
  CHECK(is_near(fifth.y, 18));
  // Beyond both ends.
  CHECK_EQ(path.at(Q16_16::from_int(-10)).x.raw, 4 * kOne);
  CHECK_EQ(path.at(Q16_16::from_int(60)).y.raw, 58 * kOne);

  path.clear();
  CHECK_OK(path.move_to({100, 50}));
  CHECK_OK(path.arc_to({50, 50}, Q16_16::from_int(1), 64));
  // 2 pi 50 = 314.16, less what chords cut off.
  CHECK(path.length().raw > 314 * kOne &&
        path.length().raw < 31416 * 656 - 20000);
  const PathPoint quarter = path.at(Q16_16::from_raw(path.length().raw / 4));
  CHECK(is_near(quarter.x, 50));
  CHECK(is_near(quarter.y, 0));
  CHECK_EQ(path.arc_to({0, 0}, {}, 16), Status::buffer_small);
  CHECK_EQ(path.arc_to({0, 0}, {}, 0), Status::bad_argument);

  path.clear();
  CHECK_OK(path.move_to({0, 0}));
  CHECK_OK(path.cubic_to({20, 0}, {40, 0}, {60, 0}, 20));
  CHECK_EQ(path.length().raw, 60 * kOne);
  CHECK(is_near(path.at(Q16_16::from_int(31)).x, 31));
}

TEST(glyphs_stand_on_their_path) {
  Run run;
  CHECK_OK(lay_out(font, "ABC", Anchor::centre, run_glyphs, run));
  PathPoint points[65];
  Path path(points);
  CHECK_OK(path.move_to({0, 30}));
  CHECK_OK(path.line_to({90, 30}));
  PathPlace on_path;
  on_path.size = 16_px;
  on_path.start = Q16_16::from_int(45);
  const RunPlace on_line = place_at(45, 30, 16);
  for (size_t i = 0; i < 3; ++i) {
    CHECK(place(font, run, i, path, on_path, {}) ==
          place(font, run, i, on_line, {}));
  }
  // Beyond the end.
  on_path.start = Q16_16::from_int(80);
  CHECK_EQ(place(font, run, 0, path, on_path, {}).pose.opacity, 255);
  CHECK_EQ(place(font, run, 2, path, on_path, {}).pose.opacity, 0);
  on_path.overflow = PathOverflow::extend;
  const PosedGlyph beyond = place(font, run, 2, path, on_path, {});
  CHECK_EQ(beyond.pose.opacity, 255);
  CHECK(beyond.at.x.raw > 90 * 64);
  on_path.overflow = PathOverflow::wrap;
  CHECK_EQ(place(font, run, 2, path, on_path, {}).at.x.raw,
           beyond.at.x.raw - 90 * 64);

  // A run that begins where a valley does shows its first glyph, whose middle
  // is nearer to the path's start than on a line.
  path.clear();
  CHECK_OK(path.move_to({0, 50}));
  CHECK_OK(path.arc_to({50, 50}, Q16_16::from_raw(kOne / 2), 64));
  on_path.overflow = PathOverflow::hide;
  on_path.start = Q16_16();
  Run from_start;
  CHECK_OK(lay_out(font, "ABC", Anchor::left, run_glyphs, from_start));
  CHECK_EQ(place(font, from_start, 0, path, on_path, {}).pose.opacity, 255);
  on_path.start = Q16_16::from_int(-16);
  CHECK_EQ(place(font, from_start, 0, path, on_path, {}).pose.opacity, 0);

  // On top of a circle that runs clockwise, glyphs lean as it does.
  path.clear();
  CHECK_OK(path.move_to({0, 50}));
  CHECK_OK(path.arc_to({50, 50}, Q16_16::from_raw(-kOne / 2), 64));
  on_path.start = Q16_16::from_raw(path.length().raw / 2);
  CHECK_OK(lay_out(font, "ABC", Anchor::centre, run_glyphs, run));
  for (size_t i = 0; i < 3; ++i) {
    later[i] = place(font, run, i, path, on_path, {});
  }
  const auto lean = [](const PosedGlyph& glyph) {
    return static_cast<int16_t>(glyph.pose.angle.raw);
  };
  CHECK(lean(later[0]) > 1000 && lean(later[0]) < 4000);
  CHECK(lean(later[2]) < -1000 && lean(later[2]) > -4000);
}

TEST(glyphs_that_slide_turn_without_a_jerk) {
  Run run;
  CHECK_OK(lay_out(font, "A", Anchor::centre, run_glyphs, run));
  PathPoint points[33];
  Path path(points);
  CHECK_OK(path.move_to({0, 40}));
  CHECK_OK(path.cubic_to({30, -20}, {60, 100}, {90, 0}, 32));
  PathPlace where;
  where.size = 16_px;
  const int32_t length = path.length().raw;
  int32_t last = 0;
  for (int32_t at = 8 * kOne; at < length - 8 * kOne; at += kOne / 4) {
    where.start.raw = at;
    const PosedGlyph glyph = place(font, run, 0, path, where, {});
    const auto angle = static_cast<int16_t>(glyph.pose.angle.raw);
    if (at != 8 * kOne) {
      // A quarter of a pixel turns it by 2 degrees at most.
      CHECK(angle - last < 364 && last - angle < 364);
    }
    last = angle;
  }
}

TEST(letters_keep_their_distance_on_bends) {
  Run run;
  CHECK_OK(lay_out(font, "AAAAA", Anchor::centre, run_glyphs, run));
  const Q26_6 size = 16_px;
  const int32_t apart =
      to_px_q16(font, size, run.glyphs[1].x - run.glyphs[0].x).raw >> 10;
  // In a valley, on a crest, and around a circle.
  for (const int32_t quarters : each_of({2, -2, 4})) {
    PathPoint points[65];
    Path path(points);
    const int32_t sign = quarters < 0 ? -1 : 1;
    CHECK_OK(path.move_to({64 - 40 * 7 / 10, 64 + sign * 40 * 7 / 10}));
    CHECK_OK(path.arc_to({64, 64}, Q16_16::from_raw(quarters * kOne / 4), 64));
    PathPlace where;
    where.size = size;
    where.start.raw = path.length().raw / 2;
    where.overflow = PathOverflow::wrap;
    PosedGlyph last;
    for (size_t i = 0; i < run.glyphs.size; ++i) {
      const PosedGlyph glyph = place(font, run, i, path, where, {});
      if (i != 0) {
        const int64_t dx = glyph.at.x.raw - last.at.x.raw;
        const int64_t dy = glyph.at.y.raw - last.at.y.raw;
        const int64_t square = dx * dx + dy * dy;
        const int64_t wanted = int64_t{apart} * apart;
        CHECK(100 * square > 94 * wanted);  // 3 % less at most
        CHECK(100 * square < 104 * wanted);
      }
      last = glyph;
    }
  }
}
