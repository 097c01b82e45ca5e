#include "inkcell/format/cell.hpp"

#include "cells/cell_access.hpp"
#include "cells/field_cell.hpp"

namespace inkcell {
namespace {

using detail::Columns;
using detail::columns_q6;
using detail::in_grid;
using detail::lagrange_q14;
using detail::Weights;

constexpr int32_t kOneQ14 = 1 << 14;

// Derivatives of the Lagrange weights: 4t - 3, 4 - 8t, 4t - 1.
Weights lagrange_slope_q14(int32_t t_q14) noexcept {
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
  const Columns c = columns_q6(samples, y);
  return (x.w1 * (c.v1 >> 2) + x.w2 * (c.v2 >> 2) + x.w3 * (c.v3 >> 2)) >> 12;
}

}  // namespace

Cell locate(const GlyphField& field, int32_t x_u, int32_t y_u) noexcept {
  return detail::has_fields(field) ? detail::locate_fields(field, x_u, y_u)
                                   : detail::locate_cell(field, x_u, y_u);
}

void SamplesRow::set_up(const uint8_t* samples,
                        uint8_t cell_size_log2,
                        int32_t y_q16) noexcept {
  detail::set_up_row(*this, samples, cell_size_log2, y_q16);
}

Q22_10 samples_distance(const uint8_t* samples,
                        uint8_t size_log2,
                        int32_t x_q16,
                        int32_t y_q16) noexcept {
  SamplesRow row;
  row.set_up(samples, size_log2, y_q16);
  return Q22_10::from_raw(row.distance_q10(x_q16));
}

int32_t detail::samples_distance_q10(const GlyphField& field,
                                     int32_t x_q16,
                                     int32_t y_q16) noexcept {
  Cell cell;
  if (in_grid(field, x_q16 >> 16, y_q16 >> 16)) {
    cell = locate_cell(field, x_q16 >> 16, y_q16 >> 16);
  }
  if (cell.samples == nullptr) {
    return cell.inside ? kSaturatedDistanceQ10 : -kSaturatedDistanceQ10;
  }
  return samples_distance(cell.samples, cell.size_log2,
                          x_q16 - cell.x0_u * (1 << 16),
                          y_q16 - cell.y0_u * (1 << 16))
      .raw;
}

Gradient detail::samples_gradient(const Cell& cell,
                                  Q16_16 x,
                                  Q16_16 y) noexcept {
  const int shift = cell.size_log2 + 2;
  const int32_t tx = (x.raw - cell.x0_u * (1 << 16)) >> shift;
  const int32_t ty = (y.raw - cell.y0_u * (1 << 16)) >> shift;
  // A quantum is 1/128 of the cell, and so is the slope's unit: Q6 quanta per
  // cell size are Q13 of pure slope.
  Gradient gradient;
  gradient.x.raw = clamp_i16(
      2 * weigh_q6(cell.samples, lagrange_slope_q14(tx), lagrange_q14(ty)));
  gradient.y.raw = clamp_i16(
      2 * weigh_q6(cell.samples, lagrange_q14(tx), lagrange_slope_q14(ty)));
  return gradient;
}

}  // namespace inkcell
