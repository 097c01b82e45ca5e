// Discs of a few pixels, from squares of distances.
#include "inkcell/kinetic/dots.hpp"

#include "limits.hpp"
#include "pixel_run.hpp"

namespace inkcell {
namespace kinetic {
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
  const auto coverage_at = [&](int32_t x_px, int32_t y_px) {
    // From the dot's centre to that of the pixel. [px, Q6]
    const int32_t right_q6 = x_px * 64 + 32 - (x.raw >> 10);
    const int32_t down_q6 = y_px * 64 + 32 - (y.raw >> 10);
    const int32_t rest_q12 =
        max(outer_q12 - right_q6 * right_q6 - down_q6 * down_q6, 0);
    // Below 2^17 times 2^8, or 2^10 times 2^12.
    const int32_t value = (rest_q12 >> 2) * scale_q16 >> 14;
    return static_cast<uint32_t>(value > 255 ? most : value * (most + 1) >> 8);
  };
  draw_pixels(intersect(dot_box(x, y, radius), sink.window), sink, coverage_at);
}

}  // namespace kinetic
}  // namespace inkcell
