// Text for displays of 1 and 2 bits, whose thin strokes stay connected.
//
// A pixel is drawn if its centre lies inside the threshold. Where a stroke
// passes between two neighbouring centres and neither is drawn, the nearer one
// is drawn as well.
#pragma once

#include <stdint.h>

#include "inkcell/effect.hpp"
#include "inkcell/fixed.hpp"

namespace inkcell {

/// Any sink will do: full coverage draws with every threshold.
///
/// A stroke passes between two centres if both lie outside and the straight
/// line between them crosses the outline; in a field, if its middle lies
/// inside. With thresholds above 0 strokes narrower than twice the threshold
/// may break.
struct Bilevel : Effect {
  constexpr explicit Bilevel(uint8_t level_count = 2,
                             Q6_10 threshold = {}) noexcept
      : Effect(detail::kBilevelMixer),
        levels(level_count),
        threshold_px(threshold) {}

  /// The display's levels. 2: coverage is 0 or 255, and only the threshold
  /// counts. 4: coverage is that of the style's filter, to the nearest of 0,
  /// 85, 170 and 255, and at least 170 where a stroke would break.
  uint8_t levels;
  /// The distance from which on a pixel is drawn, clamped to -1/2 to 1/2 px:
  /// negative values make strokes bolder.
  Q6_10 threshold_px;
};

}  // namespace inkcell
