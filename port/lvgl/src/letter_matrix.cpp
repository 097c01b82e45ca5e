#include "letter_matrix.hpp"

namespace inkcell::port {
namespace {

constexpr int32_t kTurn = 3600;  // [0.1 degrees]
constexpr int32_t kOneQ15 = 1 << 15;

int32_t times(int32_t a_q15, int32_t b_q15) noexcept {
  return static_cast<int32_t>((int64_t{a_q15} * b_q15 + kOneQ15 / 2) >> 15);
}

// Between LVGL's sines of whole degrees. [0.1 degrees -> Q15]
int32_t sine(int32_t angle) noexcept {
  angle %= kTurn;
  angle += angle < 0 ? kTurn : 0;
  const auto degrees = static_cast<int16_t>(angle / 10);
  const int32_t part = angle % 10;
  return (lv_trigo_sin(degrees) * (10 - part) +
          lv_trigo_sin(static_cast<int16_t>(degrees + 1)) * part) /
         10;
}

int32_t cosine(int32_t angle) noexcept {
  return sine(angle % kTurn + kTurn / 4);
}

// Skewed by less than a right angle. [0.1 degrees -> Q15]
int32_t tangent(int32_t angle) noexcept {
  const int32_t below = cosine(angle);
  constexpr int32_t kLeast = kOneQ15 / 64;
  return below > -kLeast && below < kLeast ? 0 : sine(angle) * kOneQ15 / below;
}

}  // namespace

LetterMatrix::LetterMatrix(const lv_draw_task_t& task,
                           const lv_draw_glyph_dsc_t& glyph) noexcept {
  int32_t across = kOneQ15;
  int32_t down = kOneQ15;
  int32_t skew_x = 0;
  int32_t skew_y = 0;
  if (task.type == LV_DRAW_TASK_TYPE_LETTER) {
    const auto& letter =
        *static_cast<const lv_draw_letter_dsc_t*>(task.draw_dsc);
    across = letter.scale_x * (kOneQ15 / LV_SCALE_NONE);
    down = letter.scale_y * (kOneQ15 / LV_SCALE_NONE);
    skew_x = letter.skew_x;
    skew_y = letter.skew_y;
  }
  is_upright = glyph.rotation % kTurn == 0 && across == kOneQ15 &&
               down == kOneQ15 && skew_x == 0 && skew_y == 0;
  if (is_upright) {
    return;
  }
  // Up, where LVGL counts down.
  const int32_t leans = -times(across, tangent(skew_x));
  const int32_t falls = -times(down, tangent(skew_y));
  const int32_t cosine_q15 = cosine(glyph.rotation);
  const int32_t sine_q15 = sine(glyph.rotation);
  x_right = times(cosine_q15, across) + times(sine_q15, falls);
  y_right = times(cosine_q15, leans) + times(sine_q15, down);
  x_up = times(cosine_q15, falls) - times(sine_q15, across);
  y_up = times(cosine_q15, down) - times(sine_q15, leans);
}

Matrix LetterMatrix::of_size(int32_t size_q6) const noexcept {
  const auto px = [size_q6](int32_t value_q15) noexcept {
    const int64_t px_q16 = int64_t{value_q15} * size_q6 / 32;
    constexpr int64_t kMost = INT32_MAX;
    return Q16_16::from_raw(static_cast<int32_t>(
        px_q16 < -kMost ? -kMost : (px_q16 > kMost ? kMost : px_q16)));
  };
  return {px(x_right), px(x_up), px(y_right), px(y_up)};
}

}  // namespace inkcell::port
