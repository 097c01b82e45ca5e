// Perceptual rules: which pixels become darker and lighter, and that no picture
// depends on how it is cut.
#include "inkcell/edge_contrast.hpp"

#include "check.hpp"
#include "effect_canvas.hpp"
#include "effect_glyph.hpp"
#include "font_builder.hpp"
#include "random.hpp"
#include "rounds.hpp"

namespace {

using namespace inkcell;
using effect::check_windows;
using effect::draw;
using effect::field_of;
using effect::kAll;
using effect::kSide;
using effect::picture;
using effect::style_of;
using effect::whole;

// Changes of coverage in the left and the right half of the picture.
struct Change {
  int32_t left;
  int32_t right;
};

Change change_of(const GlyphField& field,
                 TextStyle& style,
                 FinePoint origin,
                 int32_t middle_x,
                 const EdgeContrast& edge_contrast) {
  style.set_effect({});
  draw(field, style, origin);
  effect::keep();
  style.set_effect(edge_contrast_effect(edge_contrast));
  draw(field, style, origin);
  Change change = {0, 0};
  for (int32_t i = 0; i < kSide * kSide; ++i) {
    const int32_t x = i % kSide + kAll.x0;
    (x < middle_x ? change.left : change.right) += picture[i] - whole[i];
  }
  return change;
}

}  // namespace

// A bar from 200 to 440 u: its left edge darker, its right one lighter.
TEST(left_edges_are_darker_and_right_ones_lighter) {
  const GlyphField field = field_of(font_builder::bar);
  for (int turned = 0; turned < 2; ++turned) {
    TextStyle style = style_of(32 * 64, turned != 0);
    // The bar's middle, 10 px along the baseline and up, lands about (16, 16).
    const FinePoint origin = turned != 0 ? FinePoint(2 * 1024, 18 * 1024)
                                         : FinePoint(6 * 1024 + 512, 26 * 1024);
    const Change change = change_of(field, style, origin, 16, {90, 0});
    CHECK(change.left > 120);
    CHECK(change.right < -120);
    // Weight stays: the ends of the bar are an upper and a lower edge.
    const int32_t sum = change.left + change.right;
    CHECK(sum < 40 && sum > -40);
  }
}

// At 10 px the ring is 1.2 px wide: both edges meet in it. At 40 px they do
// not.
TEST(only_thin_strokes_are_darker) {
  const GlyphField field = field_of(font_builder::ring);
  TextStyle thin = style_of(10 * 64, false);
  TextStyle wide = style_of(40 * 64, false);
  const FinePoint origin(10 * 1024 + 300, 26 * 1024);
  const Change at_thin = change_of(field, thin, origin, kAll.x0, {0, 128});
  CHECK(at_thin.right > 120);
  const Change at_wide = change_of(field, wide, origin, kAll.x0, {0, 128});
  CHECK_EQ(at_wide.right, 0);
}

TEST(windows_do_not_change_perceptual_pictures) {
  const EdgeContrast edge_contrast;
  for (Rounds rounds(81, INKCELL_BOARD_FIRMWARE ? 3 : 16); rounds.next();) {
    Random& random = rounds.random;
    const int32_t round = rounds.number;
    TextStyle style =
        style_of(random.between(8 * 64, 40 * 64), (round & 1) != 0);
    style.set_effect(edge_contrast_effect(edge_contrast));
    check_windows(field_of(font_builder::ring), style,
                  {random.between(0, 9999), random.between(9999, 30000)});
  }
}
