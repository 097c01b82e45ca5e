#include "cell_values.hpp"

namespace inkcell::detail {
namespace {

// Derivatives of the Lagrange weights: 4t - 3, 4 - 8t, 4t - 1.
CellWeights slopes_q14(int32_t t_q14) noexcept {
  constexpr int32_t kOneQ14 = 1 << 14;
  return {4 * t_q14 - 3 * kOneQ14, 4 * kOneQ14 - 8 * t_q14,
          4 * t_q14 - kOneQ14};
}

int16_t clamp_i16(int32_t value) noexcept {
  if (value < INT16_MIN) {
    return INT16_MIN;
  }
  return static_cast<int16_t>(value > INT16_MAX ? INT16_MAX : value);
}

// A component of the gradient: the sum of the nine offsets with weights in x
// and y. A quantum is 1/128 of the cell, so that quanta in Q6 over the size of
// the cell are a slope in Q13.
int16_t slope_q14(const uint8_t* samples,
                  const CellWeights& x,
                  const CellWeights& y) noexcept {
  const CellColumns c = cell_columns_q6(samples, y);
  return clamp_i16(
      2 *
      ((x.w1 * (c.v1 >> 2) + x.w2 * (c.v2 >> 2) + x.w3 * (c.v3 >> 2)) >> 12));
}

// A place in a cell. [Q14]
int32_t part_q14(uint32_t place_q16, uint32_t size_log2) noexcept {
  return static_cast<int32_t>(place_q16 >> (size_log2 + 2));
}

}  // namespace

Gradient cell_gradient(const uint8_t* samples,
                       uint32_t size_log2,
                       uint32_t x_q16,
                       uint32_t y_q16) noexcept {
  const int32_t tx = part_q14(x_q16, size_log2);
  const int32_t ty = part_q14(y_q16, size_log2);
  Gradient gradient;
  gradient.x.raw = slope_q14(samples, slopes_q14(tx), weights_q14(ty));
  gradient.y.raw = slope_q14(samples, weights_q14(tx), slopes_q14(ty));
  return gradient;
}

FieldPoint cell_point(const uint8_t* samples,
                      uint32_t size_log2,
                      uint32_t x_q16,
                      uint32_t y_q16) noexcept {
  const int32_t tx = part_q14(x_q16, size_log2);
  const int32_t ty = part_q14(y_q16, size_log2);
  const SamplesRow row = cell_row(samples, size_log2, y_q16);
  FieldPoint point;
  point.distance.raw = row.distance_q10(static_cast<int32_t>(x_q16));
  point.gradient.x.raw =
      clamp_i16(2 * (row.b_q6 + ((2 * row.c_q6 * tx) >> 14)));
  point.gradient.y.raw = slope_q14(samples, weights_q14(tx), slopes_q14(ty));
  return point;
}

}  // namespace inkcell::detail
