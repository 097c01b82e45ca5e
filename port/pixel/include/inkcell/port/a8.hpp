// A sink that collects coverage: 8 bits, 0 empty, 255 full.
#pragma once

#include <stdint.h>

#include "inkcell/port/pixel.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace port {

/// Coverage c over old coverage a gives c + (255 - c) * a / 255, rounded to
/// nearest: drawing never lowers coverage.
struct A8Target {
  Strip strip;
};

/// `target` must outlive `out`. Errors: see pixel.hpp.
Status make_sink(A8Target& target, Sink& out) noexcept;

}  // namespace port
}  // namespace inkcell
