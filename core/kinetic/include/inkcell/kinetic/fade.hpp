// Opacity: a sink that passes a part of the coverage on.
#pragma once

#include <stdint.h>

#include "inkcell/strip.hpp"

namespace inkcell {
namespace kinetic {

/// Coverage times opacity / 255, rounded to the nearest, into another sink.
struct Fade {
  const Sink* target = nullptr;  // must outlive the fading sink
  uint8_t opacity = 255;
};

/// A sink that draws into fade.target. `fade` must outlive it. Sub-pixels are
/// drawn in grey.
Sink make_sink(const Fade& fade) noexcept;

}  // namespace kinetic
}  // namespace inkcell
