// A sink for 4-bit grey, two pixels a byte.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// Blends in 16 levels.
struct Grey4Target {
  Strip strip;
  uint8_t level = 15;  // of the foreground, 0..15; else bad_argument
  BitOrder order = BitOrder::high_left;
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(Grey4Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
