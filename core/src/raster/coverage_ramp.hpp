// Filters, as inner loops read them.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"

namespace inkcell {
namespace detail {

// What turns distances into coverage.
struct CoverageRamp {
  int32_t low_q22;     // the least distance that is not transparent [px]
  uint32_t width_q22;  // from there to the least that is opaque
  uint32_t scale;      // entries per 1/1024 px, as in Filter
  const uint8_t* table;

  explicit CoverageRamp(const Filter& filter) noexcept
      : low_q22((filter.outside_q10 + 1) * (1 << 12)),
        width_q22(
            static_cast<uint32_t>(filter.inside_q10 - filter.outside_q10 - 1)
            << 12),
        scale(filter.scale),
        table(filter.table) {}

  // How far a distance lies above the lower end; on the ramp if below
  // width_q22.
  __attribute__((always_inline)) uint32_t way_q22(
      int32_t distance_q22) const noexcept {
    return static_cast<uint32_t>(distance_q22) - static_cast<uint32_t>(low_q22);
  }
  // Filter::coverage on the ramp.
  __attribute__((always_inline)) uint8_t at(uint32_t way_q22) const noexcept {
    return table[static_cast<uint8_t>(((way_q22 >> 12) + 1) * scale >> 14)];
  }
};

}  // namespace detail
}  // namespace inkcell
