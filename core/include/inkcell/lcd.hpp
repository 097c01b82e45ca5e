// Sub-pixels: a coverage for each coloured stripe of a pixel.
//
//   constexpr Lcd kLcd(SubPixels::rgb);
//   style.set_effect(kLcd);
//   port::set_sub_pixels(canvas);
//
// Each stripe is a third of a pixel wide and has its own coverage: fields take
// it from the distance at the stripe's centre, outlines exactly. Each channel
// is the mean of its stripe and the two beside it. Edges have three times the
// resolution across the stripes. Every stroke, however thin, adds the same to
// red, green and blue, so that it looks grey from a distance.
#pragma once

#include <stdint.h>

#include "inkcell/effect.hpp"

namespace inkcell {

/// How stripes lie in a pixel: from left to right, or from top to bottom.
enum class SubPixels : uint8_t { rgb, bgr, rgb_vertical, bgr_vertical };

/// Draws sub-pixels. A sink without coverage_rgb is given the mean of the
/// three.
///
/// The coverage of each stripe is mapped by the filter's table: gamma, contrast
/// and exponent count, weights and the width of the ramp do not.
struct Lcd : Effect {
  constexpr explicit Lcd(SubPixels sub_pixels = SubPixels::rgb,
                         uint8_t kept_colour = 255) noexcept
      : Effect(detail::kLcdMixer), order(sub_pixels), colour(kept_colour) {}

  SubPixels order;
  /// How much of the difference between the channels is kept: 255 all of it, 0
  /// none (grey). Lower values take colour off thin strokes, and some
  /// sharpness.
  uint8_t colour;
};

}  // namespace inkcell
