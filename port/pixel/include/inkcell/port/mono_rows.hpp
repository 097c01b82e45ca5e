// A sink for 1-bit pixels, eight along the row in a byte.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// A pixel is drawn if its coverage is at least the threshold.
struct MonoRowsTarget {
  Strip strip;
  uint8_t threshold = 128;  // 1..255; else bad_argument
  uint8_t level = 1;        // 1 sets the bits of drawn pixels, 0 clears them
  BitOrder order = BitOrder::high_left;
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(MonoRowsTarget& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
