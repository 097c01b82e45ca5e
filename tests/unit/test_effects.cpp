// Effects: outline and fill in windows of their own, and reach up to the band.
#include "inkcell/effect.hpp"

#include "check.hpp"
#include "effect_canvas.hpp"
#include "effect_glyph.hpp"
#include "inkcell/bilevel.hpp"
#include "inkcell/edge_contrast.hpp"
#include "inkcell/field/draw.hpp"
#include "inkcell/lcd.hpp"
#include "inkcell/motion_blur.hpp"
#include "inkcell/shadow.hpp"
#include "inkcell/stroke.hpp"
#include "inkcell/supersample.hpp"
#include "own_effects.hpp"
#include "picture.hpp"
#include "pixels.hpp"

using namespace inkcell;

namespace {

// Each fails if it is drawn outside its window.
using Large = Picture<24, 24>;
using Part = Picture<11, 9>;

Large whole_outline;
Large whole_fill;

template <typename First, typename Second>
void draw_into(First& outline_picture, Second& fill_picture) {
  const GlyphField field = effect::field_of(font_builder::disc);
  const Stroke stroke(kFilterText, Q6_10::from_raw(1500), StrokePlace::outer);
  Style style(24_px, kFilterText);
  const Sink fill = fill_picture.sink();
  const StrokeAndFill both(stroke, &fill);
  style.set_effect(both);
  draw_field(field, style, {2048, 20 << 10}, outline_picture.sink());
}

// Whether a picture shows what the whole one does there, something and nothing.
template <typename Drawn>
void check_part(const Drawn& part, const Large& whole) {
  int32_t drawn = 0;
  for (const auto [x, y] : pixels_of({4, 5, 4 + 11, 5 + 9})) {
    CHECK_EQ(part.at(x, y), whole.at(x, y));
    drawn += part.at(x, y) != 0 ? 1 : 0;
  }
  CHECK(drawn > 0 && drawn < 11 * 9);
}

}  // namespace

TEST(outline_and_fill_are_drawn_where_both_windows_are) {
  draw_into(whole_outline, whole_fill);
  {
    Large outline;
    Part fill(4, 5);
    draw_into(outline, fill);
    check_part(fill, whole_fill);
    check_part(outline, whole_outline);
    CHECK(outline.lies_in({4, 5, 4 + 11, 5 + 9}));
  }
  {
    Part outline(4, 5);
    Large fill;
    draw_into(outline, fill);
    check_part(outline, whole_outline);
    check_part(fill, whole_fill);
    CHECK(fill.lies_in({4, 5, 4 + 11, 5 + 9}));
  }
}

// Distances are good up to the first unit that is beyond the band.
TEST(filters_may_reach_to_the_end_of_the_band) {
  FontRange range;
  range.band_u = 127;
  const Q26_6 size = 16_px;  // 128 u are 2 px
  CHECK_OK(check_reach(range, size, shadow_filter(Q6_10::from_raw(2048))));
  CHECK_EQ(check_reach(range, size, shadow_filter(Q6_10::from_raw(2049))),
           Status::beyond_band);
}

// FNV-1a of the picture: another one would not fit the stack of small boards.
static uint32_t picture_hash() {
  uint32_t hash = 2166136261;
  const Rect all = effect::kAll;
  for (const auto [x, y] : pixels_of(all)) {
    hash = (hash ^ effect::picture.at(x, y)) * 16777619;
  }
  return hash;
}

// Upright and turned, whatever the window.
TEST(every_effect_draws_fields) {
  constexpr Lcd kLcd;
  constexpr Lcd kLcdVertical(SubPixels::rgb_vertical);
  constexpr Bilevel kTwoLevels;
  constexpr Bilevel kFourLevels(4);
  static constexpr Stroke kStroke(kFilterText, Q6_10::from_raw(700),
                                  StrokePlace::inner);
  constexpr EdgeContrast kContrast;
  constexpr Supersample kSupersample;
  constexpr MotionBlur kBlur({Q26_6::from_raw(150), Q26_6::from_raw(-70)});
  const Effect* const effects[] = {&kLcd,
                                   &kLcdVertical,
                                   &kTwoLevels,
                                   &kFourLevels,
                                   &kStroke,
                                   &kContrast,
                                   &kSupersample,
                                   &kBlur,
                                   &own_effects::kHatch,
                                   &own_effects::kHalo,
                                   &own_effects::kRelief};
  const GlyphField field = effect::field_of(font_builder::ring);
  for (int32_t turn = 0; turn < 2; ++turn) {
    Style style = effect::style_of(23 * 64 + 5, turn != 0);
    const FinePoint origin(3 * 1024 + 77, (turn != 0 ? 5 : 28) * 1024 + 300);
    effect::draw(field, style, origin);
    const uint32_t plain = picture_hash();
    for (const Effect* effect : effects) {
      style.set_effect(*effect);
      effect::check_windows(field, style, origin);
      CHECK(effect::picture.ink() > 255 * 20);
      CHECK(picture_hash() != plain);
    }
  }
}
