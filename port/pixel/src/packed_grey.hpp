// The canvases of grey of 2 and 4 bits, which differ only in the number of
// bits.
#pragma once

#include <stdint.h>

#include "packed.hpp"

namespace inkcell::port::detail {

/// `Pixels` has a strip, a level and a bit order; a pixel has 1 << kBitsLog2
/// bits.
template <typename Pixels, uint32_t kBitsLog2>
struct PackedGrey {
  static constexpr uint32_t kMaxLevel = (1u << (1u << kBitsLog2)) - 1;
  static constexpr uint32_t kEveryPixel = 0xff / kMaxLevel;  // level 1 in all

  static void cover(const Pixels& pixels,
                    const Run& run,
                    const uint8_t* coverage) noexcept {
    blend_packed(row_at(pixels.strip, run.y), static_cast<uint32_t>(run.x),
                 coverage, static_cast<uint32_t>(run.count), kBitsLog2,
                 pixels.level, pixels.order);
  }

  static void fill_run(const Pixels& pixels, const Run& run) noexcept {
    fill_packed(row_at(pixels.strip, run.y), static_cast<uint32_t>(run.x),
                static_cast<uint32_t>(run.count), kBitsLog2,
                static_cast<uint8_t>(pixels.level * kEveryPixel), pixels.order);
  }
};

template <typename Pixels, PixelFormat kFormat, uint32_t kBitsLog2>
inline constexpr SinkKind kPackedGrey = {
    coverage_of<Pixels, PackedGrey<Pixels, kBitsLog2>::cover>,
    solid_of<Pixels, PackedGrey<Pixels, kBitsLog2>::fill_run>, nullptr, nullptr,
    layout_of(kFormat)};

}  // namespace inkcell::port::detail
