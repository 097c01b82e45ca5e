// Ordered dither, for canvases of 1, 2 and 4 bits.
//
// A 4 x 4 matrix, fixed on the screen, decides which pixels round up: 17 shades
// from 1 bit, 49 from 2. Good for shadows and glows, bad for text. Solid pixels
// are the same with and without.
#pragma once

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port {
namespace detail {
void set_dither(const MonoRowsPixels& pixels, Sink& sink) noexcept;
void set_dither(const MonoPagesPixels& pixels, Sink& sink) noexcept;
void set_dither(const Grey2Pixels& pixels, Sink& sink) noexcept;
void set_dither(const Grey4Pixels& pixels, Sink& sink) noexcept;
}  // namespace detail

/// From here on a canvas dithers. With 1 bit the threshold shifts the shades:
/// 128 is neutral, less is darker.
template <typename Pixels>
void set_dither(Canvas<Pixels>& canvas) noexcept {
  detail::set_dither(canvas.pixels(), canvas);
}

}  // namespace inkcell::port
