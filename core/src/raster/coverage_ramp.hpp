// Filters, as inner loops read them.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"

namespace inkcell {
namespace detail {

// From distances to bytes: an entry of a table where a distance lies on the
// ramp, 0 below it and 255 above.
struct CoverageRamp {
  int32_t low_q22;     // the least distance on the ramp [px]
  uint32_t width_q22;  // from there to the least above it
  uint32_t scale;      // entries per 1/1024 px, as in Filter
  const uint8_t* table;

  explicit CoverageRamp(const Filter& filter) noexcept
      : CoverageRamp(
            filter.outside_q10, filter.inside_q10, filter.scale, filter.table) {
  }
  CoverageRamp(int32_t outside_q10,
               int32_t inside_q10,
               uint32_t its_scale,
               const uint8_t* its_table) noexcept
      : low_q22((outside_q10 + 1) * (1 << 12)),
        width_q22(static_cast<uint32_t>(inside_q10 - outside_q10 - 1) << 12),
        scale(its_scale),
        table(its_table) {}

  int32_t high_q22() const noexcept {
    return low_q22 + static_cast<int32_t>(width_q22);
  }
  // How far a distance lies above the lower end; on the ramp if below
  // width_q22.
  __attribute__((always_inline)) uint32_t above_q22(
      int32_t distance_q22) const noexcept {
    return static_cast<uint32_t>(distance_q22) - static_cast<uint32_t>(low_q22);
  }
  // Filter::coverage on the ramp.
  __attribute__((always_inline)) uint8_t at(uint32_t above_q22) const noexcept {
    return table[static_cast<uint8_t>(((above_q22 >> 12) + 1) * scale >> 14)];
  }
  uint8_t byte_of(int32_t distance_q22) const noexcept {
    const uint32_t above = above_q22(distance_q22);
    return above < width_q22        ? at(above)
           : distance_q22 < low_q22 ? uint8_t{0}
                                    : uint8_t{255};
  }
};

// The distance from which on, on both sides, coverage is 0 or 255. [px, Q22]
inline int32_t reach_of(const CoverageRamp& ramp) noexcept {
  const int32_t out = 1 - (ramp.low_q22 >> 12);
  const int32_t out_size = out < 0 ? -out : out;
  const int32_t in = ramp.high_q22() >> 12;
  const int32_t in_size = in < 0 ? -in : in;
  return ((out_size > in_size ? out_size : in_size) + 1) * (1 << 12);
}

}  // namespace detail
}  // namespace inkcell
