// A canvas of 2-bit grey, four pixels a byte.
#pragma once

#include <stdint.h>

#include "inkcell/few_levels.hpp"
#include "inkcell/port/level_canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {
struct Grey2Pixels {
  Strip strip;
  uint8_t level;
  BitOrder order;

  static const SinkKind kKind;
};
}  // namespace detail

/// Blends in 4 levels, 0 to 3.
class Grey2Canvas : public detail::LevelCanvas<detail::Grey2Pixels, 3> {
 public:
  using LevelCanvas::LevelCanvas;

  /// As MonoPagesCanvas::style().
  static constexpr Style style(Q26_6 size) noexcept {
    return four_level_style(size);
  }
};

}  // namespace inkcell::port
