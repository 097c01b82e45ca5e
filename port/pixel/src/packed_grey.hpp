// The sinks for grey of 2 and 4 bits, which differ only in the number of bits.
#pragma once

#include <stdint.h>

#include "packed.hpp"

namespace inkcell {
namespace port {
namespace detail {

/// `Target` has a strip, a level and a bit order; a pixel has 1 << kBitsLog2
/// bits.
template <typename Target, PixelFormat kFormat, uint32_t kBitsLog2>
struct PackedGrey {
  static constexpr uint32_t kMaxLevel = (1u << (1u << kBitsLog2)) - 1;
  static constexpr uint32_t kEveryPixel = 0xff / kMaxLevel;  // level 1 in all

  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) noexcept {
    const auto& target = *static_cast<const Target*>(context);
    Run run{x, y, count, 0};
    if (clip(target.strip, run)) {
      blend_packed(row_at(target.strip, run.y), static_cast<uint32_t>(run.x),
                   coverage + run.skipped, static_cast<uint32_t>(run.count),
                   kBitsLog2, target.level, target.order);
    }
  }

  static void solid(void* context,
                    int32_t x,
                    int32_t y,
                    int32_t count) noexcept {
    const auto& target = *static_cast<const Target*>(context);
    Run run{x, y, count, 0};
    if (clip(target.strip, run)) {
      fill_packed(row_at(target.strip, run.y), static_cast<uint32_t>(run.x),
                  static_cast<uint32_t>(run.count), kBitsLog2,
                  static_cast<uint8_t>(target.level * kEveryPixel),
                  target.order);
    }
  }

  static Status open(Target& target, Sink& out) noexcept {
    if (target.level > kMaxLevel) {
      return Status::bad_argument;
    }
    static constexpr SinkKind kKind = {coverage, solid, layout_of(kFormat)};
    return open_sink(target.strip, kKind, &target, out);
  }
};

}  // namespace detail
}  // namespace port
}  // namespace inkcell
