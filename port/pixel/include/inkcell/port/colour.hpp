// Canvases whose colour ColourGlyphs (inkcell/layers/colour_glyphs.hpp)
// changes. Others draw glyphs in one colour.
#pragma once

#include <stdint.h>

#include "inkcell/canvas_colour.hpp"
#include "inkcell/port/canvas.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"

namespace inkcell::port {
namespace detail {

template <auto kInk, typename Pixels>
CanvasColour colour_by(Pixels& pixels,
                       decltype(CanvasColour::pixel_of) pixel_of) noexcept {
  return {&pixels,
          [](void* to, uint32_t pixel) noexcept -> uint32_t {
            auto& ink = static_cast<Pixels*>(to)->*kInk;
            const auto before = ink;
            ink = static_cast<decltype(before)>(pixel);
            return before;
          },
          pixel_of};
}

/// How light a colour is, 0 to 255, with the weights of Rec. 601.
constexpr uint32_t light_of(const LayerColour& c) noexcept {
  return static_cast<uint32_t>(77 * c.red + 150 * c.green + 29 * c.blue) >> 8;
}

constexpr uint32_t rgb_of(const LayerColour& c) noexcept {
  return static_cast<uint32_t>(c.red << 16 | c.green << 8 | c.blue);
}

inline CanvasColour colour_of(Rgb565Pixels& pixels) noexcept {
  return colour_by<&Rgb565Pixels::colour>(
      pixels, [](const LayerColour& c) noexcept -> uint32_t {
        return rgb565(c.red, c.green, c.blue);
      });
}
inline CanvasColour colour_of(Rgb888Pixels& pixels) noexcept {
  return colour_by<&Rgb888Pixels::colour>(
      pixels, [](const LayerColour& c) noexcept { return rgb_of(c); });
}
inline CanvasColour colour_of(Xrgb8888Pixels& pixels) noexcept {
  return colour_by<&Xrgb8888Pixels::colour>(
      pixels,
      [](const LayerColour& c) noexcept { return 0xff000000u | rgb_of(c); });
}
inline CanvasColour colour_of(Grey8Pixels& pixels) noexcept {
  return colour_by<&Grey8Pixels::level>(
      pixels, [](const LayerColour& c) noexcept { return light_of(c); });
}
inline CanvasColour colour_of(Grey4Pixels& pixels) noexcept {
  return colour_by<&Grey4Pixels::level>(
      pixels, [](const LayerColour& c) noexcept { return light_of(c) >> 4; });
}

inline CanvasColour pictures_of(Rgb565Pixels& pixels) noexcept {
  CanvasColour colour = colour_of(pixels);
  colour.put = put_picture;
  return colour;
}

}  // namespace detail

/// For ColourGlyphs: of a canvas of RGB565, of 24 bits, of 32 bits, whose
/// pixels are then opaque, or of 256 or 16 levels of grey, where colours count
/// by their light. The canvas must outlive it, and may be given another strip.
template <typename Pixels>
CanvasColour colour_of(Canvas<Pixels>& canvas) noexcept {
  return detail::colour_of(*static_cast<Pixels*>(canvas.context));
}

/// The same for ColourGlyphs with a ColourCache, whose pictures it draws.
inline CanvasColour pictures_of(Rgb565Canvas& canvas) noexcept {
  return detail::pictures_of(
      *static_cast<detail::Rgb565Pixels*>(canvas.context));
}

}  // namespace inkcell::port
