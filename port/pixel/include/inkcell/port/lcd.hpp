// LCD sub-pixels, for canvases of colour.
//
// Each channel is blended with its own coverage (Sink::coverage_rgb). To use
// it, set the effect Lcd (inkcell/lcd.hpp) on a style.
#pragma once

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {
void set_sub_pixels(const Rgb565Pixels& pixels, Sink& sink) noexcept;
void set_sub_pixels(const Rgb888Pixels& pixels, Sink& sink) noexcept;
void set_sub_pixels(const Xrgb8888Pixels& pixels, Sink& sink) noexcept;
}  // namespace detail

/// From here on a canvas takes a coverage for each sub-pixel.
template <typename Pixels>
void set_sub_pixels(Canvas<Pixels>& canvas) noexcept {
  detail::set_sub_pixels(canvas.pixels(), canvas);
}

}  // namespace inkcell::port
