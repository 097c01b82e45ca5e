// Opacity: a sink that scales coverage.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"

namespace inkcell {
namespace kinetic {

/// Multiplies coverage by opacity / 255, rounded to the nearest.
struct Fade {
  const Sink* target = nullptr;  // must outlive the fading sink
  uint8_t opacity = 255;
};

/// A sink that draws into fade.target. `fade` must outlive it. LCD sub-pixels
/// are drawn in grey.
Sink make_sink(const Fade& fade) noexcept;

}  // namespace kinetic
}  // namespace inkcell
