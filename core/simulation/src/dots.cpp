// Discs of a few pixels, from squares of distances.
#include "inkcell/simulation/dots.hpp"

#include "limits.hpp"

namespace inkcell::simulation {
namespace {

constexpr int32_t kLeastQ6 = 32;
constexpr int32_t kMostQ6 = 8 * 64;

int32_t limited(Q26_6 radius) noexcept {
  return clamp(radius.raw, kLeastQ6, kMostQ6);
}

}  // namespace

Rect dot_box(Q16_16 x, Q16_16 y, Q26_6 radius) noexcept {
  const int32_t r_q6 = limited(radius);
  const int32_t reach_q16 = (max(r_q6, 64) + 32) << 10;
  const auto low = [&](int32_t at) {
    return static_cast<int32_t>((int64_t{at} - reach_q16) >> 16);
  };
  const auto high = [&](int32_t at) {
    return static_cast<int32_t>((int64_t{at} + reach_q16) >> 16) + 1;
  };
  return {low(x.raw), low(y.raw), high(x.raw), high(y.raw)};
}

void draw_dot(Q16_16 x, Q16_16 y, Q26_6 radius, const Sink& sink) noexcept {
  // Coverage falls from full to none over a pixel about the edge. There the
  // square of the distance d falls by 2 r, nearly linearly:
  //     coverage = (r^2 + r - d^2) / (2 r), whose sum is pi r^2
  // A smaller dot is drawn as one of 1 px, but fainter, so that its total
  // coverage does not depend on its sub-pixel position.
  const int32_t asked_q6 = limited(radius);
  const int32_t r_q6 = max(asked_q6, 64);
  const int32_t outer_q12 = r_q6 * (r_q6 + 64);
  const int32_t most = asked_q6 < 64 ? 255 * asked_q6 * asked_q6 >> 12 : 255;
  const int32_t scale_q16 = (255 << 9) / r_q6;
  const Rect box = intersect(dot_box(x, y, radius), sink.window);
  // Pixel centres relative to the dot's centre. [px, Q6]
  const int32_t first_q6 = box.x0 * 64 + 32 - (x.raw >> 10);
  int32_t down_q6 = box.y0 * 64 + 32 - (y.raw >> 10);
  for (int32_t row = box.y0; row < box.y1; ++row, down_q6 += 64) {
    const int32_t left = outer_q12 - down_q6 * down_q6;
    if (left <= 0) {
      continue;
    }
    uint8_t coverage[kMaxSpan];
    int32_t count = 0;
    int32_t right_q6 = first_q6;
    for (; count < box.x1 - box.x0; ++count, right_q6 += 64) {
      const int32_t rest_q12 = max(left - right_q6 * right_q6, 0);
      // Below 2^17 times 2^8, or 2^10 times 2^12.
      const int32_t value = (rest_q12 >> 2) * scale_q16 >> 14;
      coverage[count] =
          static_cast<uint8_t>(value > 255 ? most : value * (most + 1) >> 8);
    }
    if (count != 0) {
      sink.coverage(sink.context, box.x0, row, coverage, count);
    }
  }
}

}  // namespace inkcell::simulation
