// Motion blur: what it is the mean of, and that no picture depends on how it is
// cut.
#include "inkcell/motion_blur.hpp"

#include "check.hpp"
#include "effect_canvas.hpp"
#include "effect_glyph.hpp"
#include "font_builder.hpp"
#include "picture.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using effect::check_windows;
using effect::draw;
using effect::field_of;
using effect::kSide;
using effect::magnitude;
using effect::picture;
using effect::style_of;
using effect::whole;

uint16_t sums[kSide * kSide];  // of 64 pictures

Point way_of(int32_t x_q6, int32_t y_q6) {
  return {Q26_6::from_raw(x_q6), Q26_6::from_raw(y_q6)};
}

}  // namespace

// The mean of 64 plain pictures along the way.
TEST(blurred_pictures_are_means_of_shifted_ones) {
  const GlyphField field = field_of(font_builder::ring);
  const int32_t ways[][2] = {{40, 0}, {0, -64}, {150, 90}, {-300, 20}};
  for (const auto& way : ways) {
    for (int turned = 0; turned < 2; ++turned) {
      TextStyle style = style_of(30 * 64, turned != 0);
      const FinePoint origin(6 * 1024 + 300, 25 * 1024 + 77);
      for (uint16_t& sum : sums) {
        sum = 0;
      }
      for (int32_t i = 0; i < 64; ++i) {
        // From half the way before to half the way behind, in 1/128 of it.
        const int64_t part = 2 * i - 63;
        draw(field, style,
             {origin.x_q10 + way[0] * 16 * part / 128,
              origin.y_q10 + way[1] * 16 * part / 128});
        for (int32_t j = 0; j < kSide * kSide; ++j) {
          sums[j] = static_cast<uint16_t>(sums[j] + picture[j]);
        }
      }
      MotionBlur blur;
      CHECK_OK(make_motion_blur(kFilterText, way_of(way[0], way[1]), blur));
      style.set_effect(motion_blur_effect(blur));
      draw(field, style, origin);
      int32_t total = 0;
      for (int32_t j = 0; j < kSide * kSide; ++j) {
        const int32_t difference = magnitude(picture[j] - (sums[j] + 32) / 64);
        CHECK(difference <= 14);
        total += difference;
      }
      CHECK(total <= kSide * kSide);  // a level on average
    }
  }
}

TEST(no_way_is_no_blur) {
  const GlyphField field = field_of(font_builder::disc);
  TextStyle style = style_of(30 * 64, false);
  const FinePoint origin(6 * 1024 + 300, 25 * 1024 + 77);
  draw(field, style, origin);
  effect::keep();
  MotionBlur blur;
  CHECK_OK(make_motion_blur(kFilterText, way_of(0, 0), blur));
  style.set_effect(motion_blur_effect(blur));
  draw(field, style, origin);
  for (int32_t i = 0; i < kSide * kSide; ++i) {
    CHECK(magnitude(picture[i] - whole[i]) <= 1);
  }
}

TEST(windows_do_not_change_blurred_pictures) {
  for (Rounds rounds(71, INKCELL_BOARD_FIRMWARE ? 3 : 16); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    MotionBlur blur;
    CHECK_OK(make_motion_blur(
        kFilterText,
        way_of(random.between(-400, 400), random.between(-400, 400)), blur));
    TextStyle style =
        style_of(random.between(8 * 64, 40 * 64), (round & 1) != 0);
    style.set_effect(motion_blur_effect(blur));
    check_windows(field_of(font_builder::ring), style,
                  {random.between(0, 9999), random.between(9999, 30000)});
  }
}

// Rows of the largest grid, small and turned, begin 2^15 u and more away from
// the glyph.
TEST(windows_do_not_change_large_grids) {
  constexpr int32_t kLength = 160;
  effect::glyph_record.reset();
  effect::glyph_record.tile_log2 = 10;
  effect::glyph_record.x0_u = 0;
  effect::glyph_record.y0_u = -15360;
  effect::glyph_record.tiles_x = 15;
  effect::glyph_record.tiles_y = 15;
  effect::glyph_record.reference_count = 15 * 15;
  for (uint32_t i = 0; i < 15 * 15; ++i) {
    effect::glyph_record.references[i] = format::glyph::kInside;
  }
  effect::glyph_record.write(effect::glyph_bytes);
  GlyphField field;
  CHECK_OK(GlyphField::open({effect::glyph_bytes, effect::glyph_record.size()},
                            field));
  MotionBlur blur;
  CHECK_OK(make_motion_blur(kFilterText, way_of(2048, -2048), blur));
  TextStyle style = style_of(4 * 64, true);
  style.set_effect(motion_blur_effect(blur));
  const Rect box = field_box(field, style, {0, 0});
  CHECK(box.x1 - box.x0 <= kLength);
  int32_t drawn = 0;
  for (int32_t y = box.y1 - 16; y < box.y1; ++y) {
    Picture<kLength, 1> whole_row(box.x0, y);
    draw_field(field, style, {0, 0}, whole_row.sink());
    Picture<kLength, 1> parts(box.x0, y);
    Sink sink = parts.sink();
    for (int32_t x = box.x0; x < box.x1; x += 20) {
      sink.window.x0 = x;
      sink.window.x1 = x + 20;
      draw_field(field, style, {0, 0}, sink);
    }
    for (int32_t x = box.x0; x < box.x1; ++x) {
      CHECK_EQ(parts.at(x, y), whole_row.at(x, y));
      drawn += parts.at(x, y) != 0 ? 1 : 0;
    }
  }
  CHECK(drawn > 50);
}

TEST(long_ways_are_refused) {
  constexpr int32_t kMost = 32 * 64;
  constexpr int32_t kWays[][2] = {
      {kMost + 1, 0}, {-kMost - 1, 0}, {0, kMost + 1}, {0, -kMost - 1}};
  MotionBlur blur;
  CHECK_OK(make_motion_blur(kFilterText, way_of(kMost, -kMost), blur));
  CHECK_OK(make_motion_blur(kFilterText, way_of(-kMost, kMost), blur));
  for (const auto& way : kWays) {
    CHECK_EQ(make_motion_blur(kFilterText, way_of(way[0], way[1]), blur),
             Status::bad_argument);
  }
}
