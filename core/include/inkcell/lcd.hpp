// Sub-pixels: a coverage for each coloured stripe of a pixel.
//
//   style.set_effect(lcd_effect(lcd));
//   port::make_lcd_sink(target, sink);
//
// Each stripe is a third of a pixel wide and has its own coverage: fields take
// it from the distance at the stripe's centre, outlines exactly. Each channel
// is the mean of its stripe and the two beside it. Edges have three times the
// resolution across the stripes. Every stroke, however thin, adds the same to
// red, green and blue, so that it looks grey from a distance.
#pragma once

#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

/// How stripes lie in a pixel: from left to right, or from top to bottom.
enum class SubPixels : uint8_t { rgb, bgr, rgb_vertical, bgr_vertical };

/// Options of lcd_effect.
struct LcdOptions {
  SubPixels order = SubPixels::rgb;
  /// How much of the difference between the channels is kept: 255 all of it, 0
  /// none (grey). Lower values take colour off thin strokes, and some
  /// sharpness.
  uint8_t colour = 255;
};

namespace detail {
extern const Mixer kLcdMixer;
}  // namespace detail

/// Draws sub-pixels. A sink without coverage_rgb is given the mean of the
/// three. The options must outlive the style.
///
/// The coverage of each stripe is mapped by the filter's table: gamma, contrast
/// and exponent count, weights and the width of the ramp do not.
constexpr Effect lcd_effect(const LcdOptions& lcd) noexcept {
  return {&detail::kLcdMixer, &lcd, 1};
}
Effect lcd_effect(const LcdOptions&&) = delete;

}  // namespace inkcell
