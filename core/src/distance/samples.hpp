// The distance and the gradient of a cell of nine samples.
#pragma once

#include <stdint.h>

#include "base/bytes.hpp"
#include "inkcell/format/cell.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell {
namespace detail {

// Lagrange weights of the points 0, 1/2 and 1 at t, 0 <= t < 1. They sum to
// one exactly, so that a constant is reproduced exactly.
struct Weights {
  int32_t w1;
  int32_t w2;
  int32_t w3;
};

inline Weights lagrange_q14(int32_t t_q14) noexcept {
  constexpr int32_t kOne = 1 << 14;
  const int32_t w2 = (t_q14 * (kOne - t_q14)) >> 12;
  const int32_t w3 = (t_q14 * (2 * t_q14 - kOne)) >> 14;
  return {kOne - w2 - w3, w2, w3};
}

// The three columns of a cell at the height that `w` stands for. [1/64 quantum]
struct Columns {
  int32_t v1;
  int32_t v2;
  int32_t v3;
};

inline Columns columns_q6(const uint8_t* samples, const Weights& w) noexcept {
  const uint8_t* at = samples + format::samples::kOffsets;
  const auto offset = [at](int i) noexcept {
    return static_cast<int32_t>(static_cast<int8_t>(at[i]));
  };
  return {(w.w1 * offset(0) + w.w2 * offset(3) + w.w3 * offset(5) + 128) >> 8,
          (w.w1 * offset(1) + w.w3 * offset(6) + 128) >> 8,
          (w.w1 * offset(2) + w.w2 * offset(4) + w.w3 * offset(7) + 128) >> 8};
}

// The distance at a cell's centre. [u]
inline int32_t centre_q10(const uint8_t* samples) noexcept {
  return load_i16(samples + format::samples::kCentre) *
         (1 << (10 - format::samples::kCentreFraction));
}

// SamplesRow::set_up.
inline void set_up_row(SamplesRow& row,
                       const uint8_t* samples,
                       uint8_t size_log2,
                       int32_t y_q16) noexcept {
  const Columns c = columns_q6(samples, lagrange_q14(y_q16 >> (size_log2 + 2)));
  row.a_q6 = c.v1;
  row.b_q6 = 4 * c.v2 - 3 * c.v1 - c.v3;
  row.c_q6 = 2 * (c.v1 - 2 * c.v2 + c.v3);
  row.centre_q10 = centre_q10(samples);
  row.size_log2 = size_log2;
}

// The distance and the gradient at a place in the cell, as samples_distance()
// takes it. [u, Q10]
int32_t samples_distance_q10(const uint8_t* samples,
                             uint32_t size_log2,
                             uint32_t x_q16,
                             uint32_t y_q16) noexcept;
Gradient samples_gradient(const uint8_t* samples,
                          uint32_t size_log2,
                          uint32_t x_q16,
                          uint32_t y_q16) noexcept;
// Both. The slope along x is that of the row's parabola.
FieldPoint samples_point(const uint8_t* samples,
                         uint32_t size_log2,
                         uint32_t x_q16,
                         uint32_t y_q16) noexcept;

}  // namespace detail
}  // namespace inkcell
