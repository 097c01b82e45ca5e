// A cell of nine samples: distance and gradient (equations 1 to 3 of the
// paper).
#pragma once

#include <stdint.h>

#include "base/bytes.hpp"
#include "inkcell/field/cell.hpp"
#include "inkcell/format/rom.hpp"

namespace inkcell::detail {

// Lagrange weights of the points 0, 1/2 and 1 at t, 0 <= t < 1. They sum to
// one exactly, so that a constant is reproduced exactly.
struct CellWeights {
  int32_t w1;
  int32_t w2;
  int32_t w3;
};

inline CellWeights weights_q14(int32_t t_q14) noexcept {
  constexpr int32_t kOne = 1 << 14;
  const int32_t w2 = (t_q14 * (kOne - t_q14)) >> 12;
  const int32_t w3 = (t_q14 * (2 * t_q14 - kOne)) >> 14;
  return {kOne - w2 - w3, w2, w3};
}

// The three columns of a cell at the height that `w` stands for. [1/64 quantum]
struct CellColumns {
  int32_t v1;
  int32_t v2;
  int32_t v3;
};

inline CellColumns cell_columns_q6(const uint8_t* samples,
                                   const CellWeights& w) noexcept {
  const uint8_t* at = samples + format::samples::kOffsets;
  const auto offset = [at](int i) noexcept {
    return static_cast<int32_t>(static_cast<int8_t>(at[i]));
  };
  return {(w.w1 * offset(0) + w.w2 * offset(3) + w.w3 * offset(5) + 128) >> 8,
          (w.w1 * offset(1) + w.w3 * offset(6) + 128) >> 8,
          (w.w1 * offset(2) + w.w2 * offset(4) + w.w3 * offset(7) + 128) >> 8};
}

// The distance at a cell's centre. [u]
inline int32_t cell_centre_q10(const uint8_t* samples) noexcept {
  return load_i16(samples + format::samples::kCentre) *
         (1 << (10 - format::samples::kCentreFraction));
}

// SamplesRow::set_up.
__attribute__((always_inline)) inline SamplesRow cell_row(
    const uint8_t* samples, uint32_t size_log2, uint32_t y_q16) noexcept {
  const CellColumns c = cell_columns_q6(
      samples, weights_q14(static_cast<int32_t>(y_q16 >> (size_log2 + 2))));
  SamplesRow row;
  row.a_q6 = c.v1;
  row.b_q6 = 4 * c.v2 - 3 * c.v1 - c.v3;
  row.c_q6 = 2 * (c.v1 - 2 * c.v2 + c.v3);
  row.centre_q10 = cell_centre_q10(samples);
  row.size_log2 = static_cast<uint8_t>(size_log2);
  return row;
}

// The gradient at a place in the cell. [u, Q16]
Gradient cell_gradient(const uint8_t* samples,
                       uint32_t size_log2,
                       uint32_t x_q16,
                       uint32_t y_q16) noexcept;

// Distance and gradient. The slope along x is that of the row's parabola.
FieldPoint cell_point(const uint8_t* samples,
                      uint32_t size_log2,
                      uint32_t x_q16,
                      uint32_t y_q16) noexcept;

}  // namespace inkcell::detail
