// Equations 1 to 3 of the paper in double: what the integer core is held to.
#pragma once

#include <stdint.h>

#include "font_builder.hpp"

namespace equation {

/// The weights of the samples at 0, 1/2 and 1, or their derivatives.
struct Weights {
  double w[3];
};

constexpr Weights lagrange(double t) {
  return {{(2 * t - 1) * (t - 1), 4 * t * (1 - t), t * (2 * t - 1)}};
}

constexpr Weights slope(double t) {
  return {{4 * t - 3, 4 - 8 * t, 4 * t - 1}};
}

/// Sum of the nine offsets of a cell. [quanta of 1/128 cell size]
inline double weigh(const uint8_t* cell, const Weights& x, const Weights& y) {
  double sum = 0;
  for (int i = 0; i < 9; ++i) {
    if (i != 4) {
      const uint8_t* offsets = cell + inkcell::format::samples::kOffsets;
      const auto offset = static_cast<int8_t>(offsets[i < 4 ? i : i - 1]);
      sum += y.w[i / 3] * x.w[i % 3] * offset;
    }
  }
  return sum;
}

/// Equation 1 at (x, y) in the cell, 0 <= x, y <= 1. [u]
inline double distance(const uint8_t* cell, int size_log2, double x, double y) {
  const auto centre =
      static_cast<int16_t>(font_builder::get_u16(cell));  // Q10.6
  return centre / 64.0 + weigh(cell, lagrange(x), lagrange(y)) *
                             static_cast<double>(1 << size_log2) / 128.0;
}

/// Minus equations 2 and 3: the gradient that points inwards.
inline double slope_x(const uint8_t* cell, double x, double y) {
  return weigh(cell, slope(x), lagrange(y)) / 128.0;
}
inline double slope_y(const uint8_t* cell, double x, double y) {
  return weigh(cell, lagrange(x), slope(y)) / 128.0;
}

}  // namespace equation
