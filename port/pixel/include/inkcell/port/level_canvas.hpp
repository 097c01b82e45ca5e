// What the canvases of 2 and 4 bits of grey share.
#pragma once

#include <stdint.h>

#include "inkcell/port/canvas.hpp"
#include "inkcell/port/pixel.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::port::detail {

/// Levels over kMaxLevel are clamped.
template <typename Pixels, uint8_t kMost>
class LevelCanvas : public Canvas<Pixels> {
 public:
  static constexpr uint8_t kMaxLevel = kMost;

  explicit LevelCanvas(const Strip& strip = {},
                       uint8_t level = kMaxLevel,
                       BitOrder order = BitOrder::high_left) noexcept
      : Canvas<Pixels>(strip, clamped(level), order) {}
  LevelCanvas(const Strip& strip,
              uint8_t level,
              uint8_t background,
              BitOrder order = BitOrder::high_left) noexcept
      : LevelCanvas(strip, background, order) {
    this->fill();
    set_level(level);
  }

  /// The level of the foreground.
  void set_level(uint8_t level) noexcept {
    this->pixels_.level = clamped(level);
  }

 private:
  static constexpr uint8_t clamped(uint8_t level) noexcept {
    return level < kMaxLevel ? level : kMaxLevel;
  }
};

}  // namespace inkcell::port::detail
