#include "distance/samples.hpp"

namespace inkcell {
namespace {

using detail::Weights;

// Derivatives of the Lagrange weights: 4t - 3, 4 - 8t, 4t - 1.
Weights lagrange_slope_q14(int32_t t_q14) noexcept {
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

// Sum of the nine offsets with weights in x and y. [quanta, Q6]
int32_t weigh_q6(const uint8_t* samples,
                 const Weights& x,
                 const Weights& y) noexcept {
  const detail::Columns c = detail::columns_q6(samples, y);
  return (x.w1 * (c.v1 >> 2) + x.w2 * (c.v2 >> 2) + x.w3 * (c.v3 >> 2)) >> 12;
}

}  // namespace

int32_t detail::samples_distance_q10(const uint8_t* samples,
                                     uint32_t size_log2,
                                     uint32_t x_q16,
                                     uint32_t y_q16) noexcept {
  SamplesRow row;
  set_up_row(row, samples, static_cast<uint8_t>(size_log2),
             static_cast<int32_t>(y_q16));
  return row.distance_q10(static_cast<int32_t>(x_q16));
}

Gradient detail::samples_gradient(const uint8_t* samples,
                                  uint32_t size_log2,
                                  uint32_t x_q16,
                                  uint32_t y_q16) noexcept {
  const auto tx = static_cast<int32_t>(x_q16 >> (size_log2 + 2));
  const auto ty = static_cast<int32_t>(y_q16 >> (size_log2 + 2));
  // A quantum is 1/128 of the cell, and so is the slope's unit: Q6 quanta per
  // cell size are Q13 of pure slope.
  Gradient gradient;
  gradient.x.raw = clamp_i16(
      2 * weigh_q6(samples, lagrange_slope_q14(tx), lagrange_q14(ty)));
  gradient.y.raw = clamp_i16(
      2 * weigh_q6(samples, lagrange_q14(tx), lagrange_slope_q14(ty)));
  return gradient;
}

FieldPoint detail::samples_point(const uint8_t* samples,
                                 uint32_t size_log2,
                                 uint32_t x_q16,
                                 uint32_t y_q16) noexcept {
  const auto tx = static_cast<int32_t>(x_q16 >> (size_log2 + 2));
  const auto ty = static_cast<int32_t>(y_q16 >> (size_log2 + 2));
  SamplesRow row;
  set_up_row(row, samples, static_cast<uint8_t>(size_log2),
             static_cast<int32_t>(y_q16));
  FieldPoint point;
  point.distance.raw = row.distance_q10(static_cast<int32_t>(x_q16));
  point.gradient.x.raw =
      clamp_i16(2 * (row.b_q6 + ((2 * row.c_q6 * tx) >> 14)));
  point.gradient.y.raw = clamp_i16(
      2 * weigh_q6(samples, lagrange_q14(tx), lagrange_slope_q14(ty)));
  return point;
}

}  // namespace inkcell
