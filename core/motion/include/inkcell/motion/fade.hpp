// Opacity: sinks that scale coverage.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::motion {

/// Multiplies coverage by opacity / 255, rounded to the nearest.
struct Fade {
  const Sink* target = nullptr;  // must outlive the fading sink
  uint8_t opacity = 255;
};

/// A sink that draws into fade.target. `fade` must outlive it. LCD sub-pixels
/// are drawn in grey.
Sink make_sink(const Fade& fade) noexcept;

/// A window whose edges are soft: opacity rises from 0 at a side to 255 at so
/// many pixels inside. For text that scrolls, rolls or is revealed.
struct SoftWindow {
  const Sink* target = nullptr;  // must outlive the sink
  Rect window;                   // on the screen, sides within +-32767
  /// How far each side is soft; 0: not. [px, 0..255]
  struct {
    uint8_t left = 0;
    uint8_t top = 0;
    uint8_t right = 0;
    uint8_t bottom = 0;
  } soft;
};

/// A sink that draws into soft.target. `soft` must outlive it. LCD sub-pixels
/// are drawn in grey.
Sink make_sink(const SoftWindow& soft) noexcept;

}  // namespace inkcell::motion
