// Sub-pixels lie where plain text lies, whichever way they are drawn.
#include "inkcell/lcd.hpp"

#include "check.hpp"
#include "effect_canvas.hpp"
#include "effect_glyph.hpp"
#include "font_builder.hpp"

namespace {

using namespace inkcell;
using namespace effect;

// Where the middle of the ink lies. [1/64 px]
struct Middle {
  int32_t x_q6;
  int32_t y_q6;
};

Middle middle_of_ink() {
  int64_t x = 0;
  int64_t y = 0;
  for (int32_t i = 0; i < kSide * kSide; ++i) {
    const int32_t coverage =
        picture.at(kAll.x0 + i % kSide, kAll.y0 + i / kSide);
    x += int64_t{coverage} * (i % kSide);
    y += int64_t{coverage} * (i / kSide);
  }
  return {static_cast<int32_t>(64 * x / picture.ink()),
          static_cast<int32_t>(64 * y / picture.ink())};
}

// Sub-pixels are wider by 2/3 px on both sides, and all of that must show.
void check_place(const GlyphField& field, Style style, FinePoint origin) {
  style.clear_effect();
  draw(field, style, origin);
  CHECK(picture.ink() > 255 * 20);
  const Middle plain = middle_of_ink();
  for (uint32_t order = 0; order < 4; ++order) {
    const Lcd lcd(static_cast<SubPixels>(order));
    style.set_effect(lcd);
    draw(field, style, origin);
    const Middle middle = middle_of_ink();
    CHECK(magnitude(middle.x_q6 - plain.x_q6) <= 8);
    CHECK(magnitude(middle.y_q6 - plain.y_q6) <= 8);
  }
}

}  // namespace

TEST(sub_pixels_lie_where_text_lies) {
  constexpr font_builder::Shape kShapes[] = {
      font_builder::disc, font_builder::ring, font_builder::bar};
  for (const font_builder::Shape shape : kShapes) {
    const GlyphField field = field_of(shape);
    for (const int32_t px : each_of({16, 21, 30})) {
      for (int32_t phase = 0; phase < 4; ++phase) {
        const FinePoint shift(256 * phase, 200 * phase);
        check_place(field, style_of(px * 64, false),
                    {2 * 1024 + shift.x_q10, 32 * 1024 + shift.y_q10});
        check_place(field, style_of(px * 64, true),
                    {1024 + shift.x_q10, 9 * 1024 + shift.y_q10});
      }
    }
  }
}
