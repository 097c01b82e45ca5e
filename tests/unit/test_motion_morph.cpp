// Grids of distances, what lies between two of them, and glyphs that become
// others.
#include "check.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/motion/grid_draw.hpp"
#include "inkcell/motion/morph.hpp"
#include "inkcell/painter.hpp"
#include "outline_font.hpp"
#include "picture.hpp"
#include "pixels.hpp"
#include "random.hpp"

namespace {

using namespace inkcell;
using namespace inkcell::motion;

const Font& font = outline_record::sample_font();

constexpr int32_t kWidth = 64;
constexpr int32_t kHeight = 56;
constexpr int32_t kOne = 1 << 16;
constexpr Q26_6 kSize = 48_px;
constexpr MorphBox kBox = {kWidth, kHeight, 44, 0};
constexpr uint16_t kDiscGlyph = 1;
constexpr uint16_t kBarGlyph = 2;

int8_t memory[morph_bytes(kBox)];
GridHistogram scratch;
Picture<kWidth, kHeight> picture;
Picture<kWidth, kHeight> second;

void draw_whole(const GlyphMorph& morph, Picture<kWidth, kHeight>& out) {
  out.clear();
  morph.draw(0, 0, out.sink());
}

}  // namespace

TEST(grids_hold_distances) {
  // The bar from x = 200 to 440 u, y = 0 to 640 u, at 64 px/em: 12.5 to 27.5
  // px and 0 to 40 px. Its origin is at (4, 48).
  for (int32_t scale = 0; scale <= 2; ++scale) {
    const int32_t side = DistanceGrid::samples_of(56, scale);
    DistanceGrid grid(memory, side, side, scale);
    CHECK_EQ(grid.width(), side);
    grid.clear();
    CHECK_OK(grid.paint(font, kBarGlyph, 64_px, {4, 48}));
    for (const auto [x, y] : pixels_of(side, side)) {
      // In 1/32 of a side; off corners the nearest side decides.
      const int32_t px_q6 = ((2 * x + 1) << scale) * 32;
      const int32_t py_q6 = ((2 * y + 1) << scale) * 32;
      const int32_t left = px_q6 - (16 * 64 + 32);
      const int32_t right = (31 * 64 + 32) - px_q6;
      const int32_t top = py_q6 - 8 * 64;
      const int32_t bottom = 48 * 64 - py_q6;
      const int32_t across = left < right ? left : right;
      const int32_t along = top < bottom ? top : bottom;
      if (across < 0 && along < 0) {
        continue;
      }
      const int32_t least = across < along ? across : along;
      int32_t expected = least >> (1 + scale);
      expected = expected > 127 ? 127 : expected < -128 ? -128 : expected;
      CHECK(magnitude(grid.at(x, y) - expected) <= 1);
    }
    CHECK_EQ(grid.at(-1, 0), DistanceGrid::kOutside);
    CHECK_EQ(grid.at(0, side), DistanceGrid::kOutside);
  }
}

TEST(grids_unite_what_is_painted) {
  DistanceGrid grid(memory, kWidth, kHeight, 0);
  DistanceGrid both({memory + kWidth * kHeight, kWidth * kHeight}, kWidth,
                    kHeight, 0);
  const Point kPlaces[] = {{2, 40}, {20, 44}};
  both.clear();
  CHECK_OK(both.paint(font, kBarGlyph, kSize, kPlaces[0]));
  CHECK_OK(both.paint(font, kDiscGlyph, kSize, kPlaces[1]));
  grid.clear();
  CHECK_OK(grid.paint(font, kBarGlyph, kSize, kPlaces[0]));
  for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
    CHECK(both.at(x, y) >= grid.at(x, y));
  }
  CHECK(both.depth() >= grid.depth());
  CHECK(grid.depth() > 0);
}

TEST(grids_refuse_what_does_not_fit) {
  CHECK_EQ(DistanceGrid({memory, 99}, 10, 10, 0).width(), 0);
  CHECK_EQ(DistanceGrid({memory, 100}, 10, 10, 0).width(), 10);
  CHECK_EQ(DistanceGrid(memory, 0, 10, 0).width(), 0);
  CHECK_EQ(DistanceGrid(memory, 10, 2000, 0).width(), 0);
  CHECK_EQ(DistanceGrid(memory, 10, 10, 4).width(), 0);
  CHECK_EQ(DistanceGrid(memory, 10, 10, -1).width(), 0);
  DistanceGrid grid(memory, 10, 10, 3);
  grid.clear();
  CHECK_EQ(grid.paint(font, kBarGlyph, 31_px, {}), Status::bad_argument);
  CHECK_EQ(grid.depth(), 0);
}

TEST(morphs_end_as_plain_glyphs) {
  GlyphMorph morph(font, kSize, kFilterMotion, kBox, memory);
  Style style(kSize, kFilterMotion);
  for (uint16_t from = 1; from < 6; ++from) {
    const auto to = static_cast<uint16_t>(from % 5 + 1);
    CHECK_OK(morph.set(from, to));
    for (int32_t end = 0; end < 2; ++end) {
      morph.step(Q16_16::from_int(end), scratch);
      draw_whole(morph, picture);
      second.clear();
      const uint16_t glyph = end == 0 ? from : to;
      const int32_t advance_q6 = font.advance(glyph) * 48 * 64 / 1024;
      Painter(second.sink())
          .glyph(font, style,
                 {Q26_6::from_raw((kWidth * 64 - advance_q6) / 2),
                  Q26_6::from_int(kBox.baseline)},
                 glyph);
      CHECK(second.ink() > 255 * 100);
      CHECK(picture == second);
    }
  }
}

// Strokes of 2 to 6 samples: the area of each frame is on the line between the
// ends, no frame is empty, and no step changes much more than the mean does.
TEST(areas_go_evenly_and_nothing_pops) {
  GlyphMorph morph(font, 24_px, kFilterMotion, kBox, memory);
  constexpr int32_t kSteps = 16;
  for (uint16_t from = 2; from < 5; ++from) {
    for (uint16_t to = 2; to < 5; ++to) {
      CHECK_OK(morph.set(from, to));
      draw_whole(morph, second);
      const int32_t first = second.ink();
      morph.step(Q16_16::from_int(1), scratch);
      draw_whole(morph, picture);
      const int32_t last = picture.ink();
      const int32_t most = first > last ? first : last;
      int32_t sum = 0;
      int32_t worst = 0;
      for (int32_t i = 1; i <= kSteps; ++i) {
        morph.step(Q16_16::from_raw(kOne * i / kSteps), scratch);
        draw_whole(morph, picture);
        const int32_t even = first + (last - first) * i / kSteps;
        CHECK(magnitude(picture.ink() - even) <= most * 5 / 100);
        int32_t change = 0;
        for (const auto [x, y] : pixels_of(kWidth, kHeight)) {
          change += magnitude(picture.at(x, y) - second.at(x, y));
        }
        second = picture;
        sum += change;
        worst = change > worst ? change : worst;
      }
      CHECK(from != to || worst <= 2 * 255);
      CHECK(from == to || worst <= 2 * sum / kSteps);
    }
  }
}

TEST(morphs_do_not_depend_on_strips) {
  for (int32_t scale = 0; scale <= 2; ++scale) {
    MorphBox box = kBox;
    box.scale_log2 = scale;
    GlyphMorph morph(font, kSize, kFilterMotion, box, memory);
    CHECK_OK(morph.set(1, 4));
    morph.step(Q16_16::from_raw(kOne * 2 / 5), scratch);
    draw_whole(morph, picture);
    for (const int32_t rows : each_of({1, 3, 8})) {
      second.clear();
      second.draw_parts(rows, 29,
                        [&](const Sink& sink) { morph.draw(0, 0, sink); });
      CHECK(picture == second);
    }
  }
}

TEST(morphs_do_not_depend_on_what_was_before) {
  GlyphMorph morph(font, kSize, kFilterMotion, kBox, memory);
  CHECK_OK(morph.set(1, 2));
  CHECK_OK(morph.set(2, 3));  // 2 is known
  morph.step(Q16_16::from_raw(kOne / 3), scratch);
  draw_whole(morph, picture);
  CHECK_OK(morph.set(3, 2));
  CHECK_OK(morph.set(5, 4));
  CHECK_OK(morph.set(2, 3));
  CHECK_EQ(morph.progress().raw, 0);
  morph.step(Q16_16::from_int(9), scratch);
  morph.step(Q16_16::from_raw(kOne / 3), scratch);
  draw_whole(morph, second);
  CHECK(picture == second);
  CHECK_EQ(morph.from(), 2);
  CHECK_EQ(morph.to(), 3);
}

// Beside the glyph that the core draws with as much weight.
TEST(offsets_move_edges) {
  DistanceGrid grid(memory, kWidth, kHeight, 0);
  grid.clear();
  const Point origin = {12, 44};
  CHECK_OK(grid.paint(font, kDiscGlyph, kSize, origin));
  // [px, Q6]
  for (const int32_t offset : each_of({-96, 0, 80, 128})) {
    picture.clear();
    draw_offset(grid, Q26_6::from_raw(offset), 0, 0, kFilterText,
                picture.sink());
    const Filter filter = with_weight(
        kFilterText, Q6_10::from_raw(static_cast<int16_t>(offset * 16)));
    Style style(kSize, filter);
    second.clear();
    Painter(second.sink()).glyph(font, style, origin, kDiscGlyph);
    CHECK(picture.difference(second) <= 16);
  }
}

namespace {

// With any filter, at any place.
void draw_any(const DistanceGrid& grid, const GridLook& look, Random& random) {
  FilterSpec spec;
  spec.outside_px.raw = random.any();
  spec.inside_px.raw = random.any();
  const Filter filter = make_filter(spec);
  picture.clear();
  draw_grid(grid, look, random.between(-20, 60), random.between(-20, 60),
            filter, picture.sink());
}

}  // namespace

TEST(hostile_morphs_do_no_harm) {
  GlyphMorph empty(font, kSize, kFilterMotion, kBox, {memory, 5});
  CHECK_EQ(empty.set(1, 2), Status::buffer_small);
  empty.step(Q16_16::from_int(1), scratch);
  draw_whole(empty, picture);
  CHECK_EQ(picture.ink(), 0);
  GlyphMorph huge(font, 5000_px, kFilterMotion, kBox, memory);
  CHECK_EQ(huge.set(1, 2), Status::bad_argument);
  draw_whole(huge, picture);
  CHECK_EQ(picture.ink(), 0);

  Random random(21);
  random.fill(memory);
  for (int round = 0; round < 60; ++round) {
    const auto scale = static_cast<int32_t>(random.below(4));
    const auto side = static_cast<int32_t>(1 + random.below(12));
    const DistanceGrid a(memory, side, side, scale);
    const DistanceGrid b({memory + 500, 500}, side, side,
                         random.below(9) == 0 ? 0 : scale);
    DistanceGrid between({memory + 1000, 500}, side, side, scale);
    GridBlend how;
    how.part_q8 = random.between(-400, 700);
    how.depth_a = random.between(-200, 300);
    how.depth_b = random.between(-200, 300);
    how.area_a = random.any();
    how.area_b = random.any();
    GridLook look;
    look.cutoff = blend(a, b, how, between, scratch);
    draw_any(between, look, random);
    look.cutoff.raw = random.any();
    look.slope_q8 = random.any();
    draw_any(a, look, random);
  }
}
