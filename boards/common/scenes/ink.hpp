// The ink of a colour in a pixel format.
#pragma once

#include <stdint.h>

#include "inkcell/port/grey2.hpp"
#include "inkcell/port/grey4.hpp"
#include "inkcell/port/grey8.hpp"
#include "inkcell/port/mono_pages.hpp"
#include "inkcell/port/mono_rows.hpp"
#include "inkcell/port/rgb565.hpp"
#include "inkcell/port/rgb888.hpp"
#include "inkcell/port/xrgb8888.hpp"

namespace inkcell::scenes {

/// 0 to 255, by the weights of red, green and blue (ITU-R BT.601).
constexpr uint8_t lightness(uint32_t rgb) noexcept {
  return static_cast<uint8_t>(
      ((rgb >> 16 & 255) * 77 + (rgb >> 8 & 255) * 150 + (rgb & 255) * 29) >>
      8);
}

/// Whether a colour is ink in formats of one bit.
constexpr bool is_light(uint32_t rgb) noexcept {
  return lightness(rgb) >= 96;
}

/// Sets the colour 0xRRGGBB.
inline void set_ink(port::MonoRowsCanvas& canvas, uint32_t rgb) noexcept {
  canvas.set_level(is_light(rgb) ? 1 : 0);
}
inline void set_ink(port::MonoPagesCanvas& canvas, uint32_t rgb) noexcept {
  canvas.set_level(is_light(rgb) ? 1 : 0);
}
inline void set_ink(port::Grey2Canvas& canvas, uint32_t rgb) noexcept {
  canvas.set_level(static_cast<uint8_t>(lightness(rgb) >> 6));
}
inline void set_ink(port::Grey4Canvas& canvas, uint32_t rgb) noexcept {
  canvas.set_level(static_cast<uint8_t>(lightness(rgb) >> 4));
}
inline void set_ink(port::Grey8Canvas& canvas, uint32_t rgb) noexcept {
  canvas.set_level(lightness(rgb));
}
inline void set_ink(port::Rgb565Canvas& canvas, uint32_t rgb) noexcept {
  canvas.set_colour(port::rgb565(static_cast<uint8_t>(rgb >> 16),
                                 static_cast<uint8_t>(rgb >> 8),
                                 static_cast<uint8_t>(rgb)));
}
inline void set_ink(port::Rgb888Canvas& canvas, uint32_t rgb) noexcept {
  canvas.set_colour(rgb);
}
inline void set_ink(port::Xrgb8888Canvas& canvas, uint32_t rgb) noexcept {
  canvas.set_colour(0xff000000 | rgb);
}

}  // namespace inkcell::scenes
