// Text for displays of 1 and 2 bits, whose thin strokes stay connected.
//
// A pixel is drawn if its centre lies inside the threshold. Where a stroke
// passes between two neighbouring centres and neither is drawn, the nearer one
// is drawn as well.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

/// Options of crisp_effect.
struct CrispOptions {
  /// The display's levels. 2: coverage is 0 or 255, and only the threshold
  /// counts. 4: coverage is that of the style's filter, to the nearest of 0,
  /// 85, 170 and 255, and at least 170 where a stroke would break.
  uint8_t levels = 2;
  /// The distance from which on a pixel is drawn, -1/2 to 1/2 px: negative
  /// values make strokes bolder.
  Q6_10 threshold_px;
};

namespace detail {
extern const Mixer kCrispMixer;
}  // namespace detail

/// Any sink will do: full coverage draws with every threshold. The options must
/// outlive the style.
///
/// A stroke passes between two centres if both lie outside and the straight
/// line between them crosses the outline; in a field, if its middle lies
/// inside. With thresholds above 0 strokes narrower than twice the threshold
/// may break.
constexpr Effect crisp_effect(const CrispOptions& crisp) noexcept {
  return {&detail::kCrispMixer, &crisp, 1};
}
Effect crisp_effect(const CrispOptions&&) = delete;

}  // namespace inkcell
