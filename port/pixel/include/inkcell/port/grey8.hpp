// A sink for 8-bit grey.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

struct Grey8Target {
  Strip strip;
  uint8_t level = 255;  // of the foreground
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(Grey8Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
