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

  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) noexcept {
    const auto& pixels = *static_cast<const Pixels*>(context);
    Run run{x, y, count, 0};
    if (clip(pixels.strip, run)) {
      blend_packed(row_at(pixels.strip, run.y), static_cast<uint32_t>(run.x),
                   coverage + run.skipped, static_cast<uint32_t>(run.count),
                   kBitsLog2, pixels.level, pixels.order);
    }
  }

  static void solid(void* context,
                    int32_t x,
                    int32_t y,
                    int32_t count) noexcept {
    const auto& pixels = *static_cast<const Pixels*>(context);
    Run run{x, y, count, 0};
    if (clip(pixels.strip, run)) {
      fill_packed(row_at(pixels.strip, run.y), static_cast<uint32_t>(run.x),
                  static_cast<uint32_t>(run.count), kBitsLog2,
                  static_cast<uint8_t>(pixels.level * kEveryPixel),
                  pixels.order);
    }
  }
};

template <typename Pixels, PixelFormat kFormat, uint32_t kBitsLog2>
inline constexpr SinkKind kPackedGrey = {
    PackedGrey<Pixels, kBitsLog2>::coverage,
    PackedGrey<Pixels, kBitsLog2>::solid, nullptr, nullptr, layout_of(kFormat)};

}  // namespace inkcell::port::detail
