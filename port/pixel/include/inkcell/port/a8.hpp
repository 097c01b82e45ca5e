// A canvas that collects coverage: 8 bits, 0 empty, 255 full.
#pragma once

#include <stdint.h>

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {
struct A8Pixels {
  Strip strip;

  static const SinkKind kKind;
};
}  // namespace detail

/// Coverage c over old coverage a gives c + (255 - c) * a / 255, rounded to
/// nearest: drawing never lowers coverage.
class A8Canvas : public Canvas<detail::A8Pixels> {
 public:
  explicit A8Canvas(const Strip& strip = {}) noexcept : Canvas(strip) {}
};

}  // namespace inkcell::port
