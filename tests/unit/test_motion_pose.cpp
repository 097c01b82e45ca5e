// Poses, layout, paths and their pictures: beside plain glyphs, in any strips.
#include "check.hpp"
#include "inkcell/motion/path.hpp"
#include "inkcell/motion/pose_renderer.hpp"
#include "inkcell/motion/run.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/painter.hpp"
#include "outline_font.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;

const Font& font = outline_record::sample_font();

constexpr int32_t kWidth = 96;
constexpr int32_t kHeight = 48;
constexpr Rect kScreen = {0, 0, kWidth, kHeight};
constexpr int32_t kOne = 1 << 16;

using Page = Picture<kWidth, kHeight, Overlap::light>;
Page picture;
Page second;

void draw_whole(PoseRenderer& renderer,
                Span<const PosedGlyph> glyphs,
                Page& out) {
  out.clear();
  renderer.draw(glyphs, out.sink());
}

// Within 1/1000 px.
RunPlace place_at(int32_t x, int32_t y, int32_t size) {
  RunPlace where;
  where.origin = {x, y};
  where.size = Q26_6::from_int(size);
  return where;
}

Pose any_pose(Random& random) {
  Pose pose;
  pose.offset.x.raw = random.between(-40 * 64, 40 * 64);
  pose.offset.y.raw = random.between(-20 * 64, 20 * 64);
  pose.angle.raw = random.any();
  pose.scale_x.raw = static_cast<int16_t>(random.between(-8192, 8192));
  pose.scale_y.raw = static_cast<int16_t>(random.between(-8192, 8192));
  pose.slant.raw = static_cast<int16_t>(random.between(-8192, 8192));
  pose.weight.raw = static_cast<int16_t>(random.between(-1024, 1024));
  pose.opacity = random.any();
  return pose;
}

RunGlyph run_glyphs[16];
PosedGlyph posed[16];
PosedGlyph later[16];

}  // namespace

TEST(layout_counts_words_and_lines) {
  Run run;
  // G has no ink, and a space that the font lacks shows nothing.
  CHECK_OK(lay_out(font, "ABG GCD\n\nE", Anchor::left, run_glyphs, run));
  CHECK_EQ(run.glyphs.size, 5);
  CHECK_EQ(run.lines, 3);
  CHECK_EQ(lay_out(font, "AB", Anchor::left, {run_glyphs, 1}, run),
           Status::buffer_small);
  CHECK_EQ(run.glyphs.size, 5);
  CHECK_OK(lay_out(font, "ABGGCD\nE", Anchor::left, run_glyphs, run));
  CHECK_EQ(run.words, 3);
  CHECK_EQ(run.lines, 2);
  CHECK_EQ(run.glyphs[2].word, 1);
  CHECK_EQ(run.glyphs[4].word, 2);
  CHECK_EQ(run.glyphs[4].line, 1);
  CHECK_EQ(run.glyphs[4].y, -run.line_height);
  CHECK_EQ(run.glyphs[1].x, 768);
  CHECK_EQ(run.glyphs[2].x, 768 + 600 + 300 + 300);
  CHECK_EQ(unit_count(run, Unit::glyph), 5);
  CHECK_EQ(unit_count(run, Unit::word), 3);
  CHECK_EQ(unit_of(run, Unit::line, 4), 1);
  CHECK_OK(lay_out(font, "", Anchor::centre, run_glyphs, run));
  CHECK_EQ(run.glyphs.size, 0);
}

TEST(lines_are_aligned_and_tracked_about_their_anchor) {
  Run run;
  CHECK_OK(lay_out(font, "ABA", Anchor::centre, run_glyphs, run));
  CHECK_EQ(run.glyphs[0].x, -(768 + 600 + 768) / 2);
  CHECK_EQ(run.glyphs[0].half_gaps, -2);
  CHECK_EQ(run.glyphs[1].half_gaps, 0);
  CHECK_OK(lay_out(font, "ABA", Anchor::right, run_glyphs, run));
  CHECK_EQ(run.glyphs[0].x, -(768 + 600 + 768));
  CHECK_EQ(run.glyphs[0].half_gaps, -4);
  CHECK_EQ(run.glyphs[2].half_gaps, 0);
  RunPlace where = place_at(90, 30, 16);
  const PosedGlyph tight = place(font, run, 0, where, {});
  where.tracking = 3_px;
  const PosedGlyph wide = place(font, run, 0, where, {});
  CHECK_EQ(wide.at.x.raw, tight.at.x.raw - 6 * 64);
}

TEST(a_glyph_in_its_plain_pose_is_a_plain_glyph) {
  for (const int32_t size_q6 : each_of({1024, 1555, 2304})) {
    for (uint16_t glyph = 1; glyph < 7; ++glyph) {
      PoseRenderer renderer(font, Q26_6::from_raw(size_q6));
      PosedGlyph plain;
      plain.glyph = glyph;
      plain.at = {Q26_6::from_raw(20 * 64 + 13), Q26_6::from_raw(38 * 64 + 7)};
      draw_whole(renderer, {&plain, 1}, picture);
      second.clear();
      Style style(Q26_6::from_raw(size_q6), kFilterMotion);
      Painter(second.sink()).glyph(font, style, plain.at, glyph);
      CHECK(second.ink() > 255 * 20);
      CHECK(picture == second);
      // The pivot does not show unless something turns about it.
      plain.pivot_x = Q16_16::from_int(5);
      plain.at.x.raw += 5 * 64;
      draw_whole(renderer, {&plain, 1}, second);
      CHECK(picture == second);
    }
  }
}

TEST(pivots_of_any_size_and_height_fit) {
  constexpr int16_t kHighest = 32767;
  CHECK_EQ(pivot_height_px(32_px, 250).raw, 8 << 16);
  CHECK_EQ(pivot_height_px(32_px, -250).raw, -(8 << 16));
  CHECK_EQ(pivot_height_px(kMaxSize, kHighest).raw, 32767 << 16);
  CHECK_EQ(pivot_height_px(kMaxSize, -kHighest - 1).raw, -(32767 << 16));
  CHECK_EQ(pivot_height_px(Q26_6::from_raw(INT32_MAX), kHighest).raw,
           32767 << 16);
  CHECK_EQ(pivot_height_px(Q26_6::from_raw(INT32_MIN), kHighest).raw, 0);
}

TEST(glyphs_turn_about_their_pivot) {
  // The disc about (384, 384) u of 32 px/em: 12 px, 12 px.
  PoseRenderer renderer(font, 32_px);
  PosedGlyph disc;
  disc.glyph = 1;
  disc.at = {40, 24};
  disc.pivot_x = disc.pivot_y = Q16_16::from_int(12);
  draw_whole(renderer, {&disc, 1}, picture);
  const int32_t plain = picture.ink();
  // It looks the same after each quarter of a turn.
  for (int32_t angle = 0; angle < kOne; angle += 2048) {
    disc.pose.angle.raw = static_cast<uint16_t>(angle);
    draw_whole(renderer, {&disc, 1}, second);
    CHECK(second.ink() > plain * 997 / 1000 &&
          second.ink() < plain * 1003 / 1000);
    CHECK(angle % 16384 != 0 || picture.difference(second) <= 8);
  }
  disc.pose.angle = {};
  disc.pose.scale_x.raw = 2048;
  draw_whole(renderer, {&disc, 1}, second);
  CHECK(second.ink() > plain * 48 / 100 && second.ink() < plain * 52 / 100);
  disc.pose.scale_x.raw = -4096;
  draw_whole(renderer, {&disc, 1}, second);
  CHECK(second.ink() > plain * 99 / 100 && second.ink() < plain * 101 / 100);
}

TEST(opacity_and_weight_change_the_ink) {
  PoseRenderer renderer(font, 32_px);
  PosedGlyph disc;
  disc.glyph = 1;
  disc.at = {20, 40};
  draw_whole(renderer, {&disc, 1}, picture);
  const int32_t plain = picture.ink();
  disc.pose.opacity = 128;
  draw_whole(renderer, {&disc, 1}, picture);
  CHECK(picture.ink() > plain * 49 / 100 && picture.ink() < plain * 51 / 100);
  disc.pose.opacity = 0;
  draw_whole(renderer, {&disc, 1}, picture);
  CHECK_EQ(picture.ink(), 0);
  disc.pose.opacity = 255;
  disc.pose.weight = Q6_10::from_raw(1024);
  draw_whole(renderer, {&disc, 1}, picture);
  // A radius of 9.375 px becomes 10.375.
  CHECK(picture.ink() > plain * 121 / 100 && picture.ink() < plain * 124 / 100);
}

TEST(flips_never_blink) {
  PoseRenderer renderer(font, 32_px);
  PosedGlyph bar;
  bar.glyph = 2;
  bar.at = {40, 40};
  for (int32_t scale = -4096; scale <= 4096; scale += 64) {
    bar.pose.scale_x.raw = static_cast<int16_t>(scale);
    draw_whole(renderer, {&bar, 1}, picture);
    CHECK(picture.ink() > 255 * 8);
  }
}

TEST(strips_make_no_difference) {
  for (Random& random : Rounds(11, 12)) {
    PoseRenderer renderer(font, 20_px);
    for (uint16_t i = 0; i < 5; ++i) {
      posed[i] = {};
      posed[i].glyph = static_cast<uint16_t>(1 + random.below(6));
      posed[i].at = {random.between(0, kWidth), random.between(0, kHeight)};
      posed[i].pivot_x = posed[i].pivot_y = Q16_16::from_int(8);
      posed[i].pose = any_pose(random);
    }
    draw_whole(renderer, {posed, 5}, picture);
    for (const int32_t rows : each_of({1, 5, 16})) {
      second.clear();
      second.draw_strips(rows, [&](const Sink& sink) {
        renderer.draw({posed, 5}, sink);
      });
      CHECK(picture == second);
    }
  }
}

TEST(boxes_hold_what_is_drawn) {
  int32_t seen = 0;
  for (Random& random : Rounds(12, 60)) {
    PoseRenderer renderer(font, 20_px);
    posed[0] = {};
    posed[0].glyph = static_cast<uint16_t>(1 + random.below(6));
    posed[0].at = {random.between(0, kWidth), random.between(0, kHeight)};
    posed[0].pose = any_pose(random);
    draw_whole(renderer, {posed, 1}, picture);
    seen += picture.ink() > 0 ? 1 : 0;
    CHECK(picture.lies_in(renderer.box(posed[0])));
  }
  CHECK(seen > 30);
}

TEST(changes_are_all_in_dirty_rectangles) {
  for (Random& random : Rounds(13, 30)) {
    PoseRenderer renderer(font, 16_px);
    for (uint16_t i = 0; i < 6; ++i) {
      posed[i] = {};
      posed[i].glyph = static_cast<uint16_t>(1 + i);
      posed[i].at = {random.between(0, kWidth), random.between(8, kHeight)};
      later[i] = posed[i];
      if (random.below(3) == 0) {
        later[i].pose.offset.x.raw += random.between(-300, 300);
        later[i].pose.opacity = random.any();
      }
    }
    const size_t count = 5 + random.below(2);
    draw_whole(renderer, {posed, 6}, picture);
    draw_whole(renderer, {later, count}, second);
    Rect room[3];
    DirtyRects dirty(room);
    renderer.add_changes({posed, 6}, {later, count}, kScreen, dirty);
    for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
      int32_t holders = 0;
      for (const Rect& r : dirty.rects()) {
        holders += holds(r, x, y) ? 1 : 0;
      }
      CHECK(holders <= 1);
      CHECK(holders == 1 || picture.at(x, y) == second.at(x, y));
    }
  }
  // Nothing moves, nothing is drawn.
  PoseRenderer renderer(font, 16_px);
  Rect room[1];
  DirtyRects dirty(room);
  renderer.add_changes({posed, 6}, {posed, 6}, kScreen, dirty);
  CHECK_EQ(dirty.rects().size, 0);
}

TEST(poses_mix_the_shorter_way) {
  Pose a;
  Pose b;
  a.angle = from_degrees(350);
  b.angle = from_degrees(10);
  b.offset.x = 10_px;
  b.scale_x.raw = 8192;
  b.opacity = 5;
  const Pose middle = mix(a, b, Q16_16::from_raw(kOne / 2));
  CHECK(middle.angle.raw <= 1 || middle.angle.raw == 65535);
  CHECK_EQ(middle.offset.x.raw, 5 * 64);
  CHECK_EQ(middle.scale_x.raw, 6144);
  CHECK_EQ(middle.opacity, 130);
  CHECK(mix(a, b, Q16_16::from_int(1)) == b);
  CHECK(mix(a, b, {}) == a);
  const Pose twice = combine(b, b);
  CHECK_EQ(twice.offset.x.raw, 20 * 64);
  CHECK_EQ(twice.scale_x.raw, 16384);
  CHECK(combine(b, {}) == b);
}

TEST(pose_keys_tell_when_they_change) {
  PoseKey keys[3];
  keys[0] = {100, {}, kEaseIn};
  keys[1] = {200, {}, kEaseIn};
  keys[1].pose.offset.y = 9_px;
  keys[2] = keys[1];
  keys[2].at_ms = 300;
  for (int32_t time = 0; time < 400; ++time) {
    const int32_t due = next_due(Span<const PoseKey>(keys), time);
    for (int32_t t = time + 1; t < due && t < 400; ++t) {
      CHECK(pose_at(keys, t) == pose_at(keys, time));
    }
  }
  CHECK_EQ(next_due(Span<const PoseKey>(keys), 201), kNever);
}

TEST(lines_that_were_shaped_are_runs) {
  const uint16_t a = font.glyph_or_notdef('A');
  // A letter, a mark above it, a glyph that the font lacks, and a letter.
  const ShapedGlyph shaped[] = {
      {a, 10, 0}, {a, -5, 300}, {0xfffe, 7, 0}, {a, 600, 0}};
  const ShapedRun text = {shaped, 1000};
  Run run;
  CHECK_OK(lay_out(font, text, Anchor::right, run_glyphs, run));
  CHECK_EQ(run.glyphs.size, size_t{3});
  CHECK_EQ(run.width, 1000);
  CHECK_EQ(run.words, 1);
  constexpr int32_t kX[] = {10, 5, 612};
  for (size_t i = 0; i < 3; ++i) {
    CHECK_EQ(run.glyphs[i].x, kX[i] - 1000);
    CHECK_EQ(run.glyphs[i].y, i == 1 ? 300 : 0);
    CHECK_EQ(run.glyphs[i].advance, font.advance(a));
  }
  Run small = run;
  CHECK(lay_out(font, text, Anchor::left, {run_glyphs, 2}, small) ==
        Status::buffer_small);
  CHECK_EQ(small.glyphs.size, size_t{3});
}

TEST(hostile_poses_and_paths_do_no_harm) {
  for (Random& random : Rounds(14, 300)) {
    PoseRenderer renderer(font, Q26_6::from_raw(random.between(-99, 70000)));
    PosedGlyph glyph;
    glyph.glyph = static_cast<uint16_t>(random.below(9));
    glyph.at = {Q26_6::from_raw(random.any()), Q26_6::from_raw(random.any())};
    glyph.pivot_x.raw = random.any();
    glyph.pivot_y.raw = random.any();
    glyph.pose.offset = {Q26_6::from_raw(random.any()),
                         Q26_6::from_raw(random.any())};
    glyph.pose.angle.raw = random.any();
    glyph.pose.scale_x.raw = random.any();
    glyph.pose.scale_y.raw = random.any();
    glyph.pose.slant.raw = random.any();
    glyph.pose.weight.raw = random.any();
    draw_whole(renderer, {&glyph, 1}, picture);
    static_cast<void>(mix(glyph.pose, {}, Q16_16::from_raw(random.any())));

    PathPoint points[24];
    Path path(points);
    CHECK_OK(path.move_to(
        {Q26_6::from_raw(random.any()), Q26_6::from_raw(random.any())}));
    CHECK_OK(path.line_to(
        {Q26_6::from_raw(random.any()), Q26_6::from_raw(random.any())}));
    CHECK_OK(path.cubic_to(
        {Q26_6::from_raw(random.any()), Q26_6::from_raw(random.any())},
        {Q26_6::from_raw(random.any()), Q26_6::from_raw(random.any())},
        {Q26_6::from_raw(random.any()), Q26_6::from_raw(random.any())}, 10));
    CHECK_OK(path.arc_to(
        {Q26_6::from_raw(random.any()), Q26_6::from_raw(random.any())},
        Q16_16::from_raw(random.between(-4 * kOne, 4 * kOne)), 12));
    static_cast<void>(path.at(Q16_16::from_raw(random.any())));
    Run run;
    CHECK_OK(lay_out(font, "A", Anchor::centre, run_glyphs, run));
    PathPlace where;
    where.start.raw = random.any();
    where.size.raw = random.any();
    where.tracking.raw = random.any();
    where.lift.raw = random.any();
    where.overflow = static_cast<PathOverflow>(random.below(3));
    static_cast<void>(place(font, run, 0, path, where, {}));
  }
}
