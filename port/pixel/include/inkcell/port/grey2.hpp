// A sink for 2-bit grey, four pixels a byte.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// Blends in 4 levels.
struct Grey2Target {
  Strip strip;
  uint8_t level = 3;  // of the foreground, 0..3; else bad_argument
  BitOrder order = BitOrder::high_left;
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(Grey2Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
