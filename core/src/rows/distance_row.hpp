// Rows of signed distances: what painted outlines are to those who mix styles.
#pragma once

#include <stdint.h>

#include "rows/band.hpp"

namespace inkcell {
namespace detail {

// A row that paint_distances or paint_wide_distances painted, from left to
// right. Keeps whether it is inside from pixel to pixel.
class DistanceRow {
 public:
  DistanceRow(const Band& band, int32_t row) noexcept
      : at_(band.row(row)),
        // A 254th of the reach. [px, Q18]
        step_q8_(band.reach_q8 * 1024 / 254) {}

  // Passes over pixels.
  void skip(int32_t count) noexcept {
    for (; count != 0; --count) {
      inside_ ^= 0u - (*at_++ & 1u);
    }
  }

  // The same of four whose bytes are 0.
  void skip_word() noexcept { at_ += 4; }

  // The signed distance of the next pixel, positive inside; clamped to the
  // band's reach. In 254ths of that, at the middle of two.
  int32_t next_steps() noexcept {
    const uint32_t byte = *at_++;
    inside_ ^= 0u - (byte & 1);
    const auto steps = static_cast<int32_t>(255 - (byte & 254));
    return inside_ != 0 ? steps : -steps;
  }

  // The same. [px, Q10]
  int32_t next() noexcept { return next_steps() * step_q8_ >> 8; }

 private:
  const uint8_t* at_;
  int32_t step_q8_;
  uint32_t inside_ = 0;  // all ones: the pixel to the left is inside
};

}  // namespace detail
}  // namespace inkcell
