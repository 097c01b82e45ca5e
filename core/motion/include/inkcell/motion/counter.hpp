// A number whose wheels roll (recipes.hpp).
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/motion/digit_roll.hpp"
#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/timeline.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"

namespace inkcell::motion {

/// A number whose wheels roll, as those of an odometer do: a wheel turns while
/// the one to its right goes from 9 to 0. Leading zeros are blank.
class Counter {
 public:
  /// `digits` wheels, 1 to 9; `origin` is the left end of their baseline.
  Counter(const Font& font,
          const Style& style,
          Point origin,
          int32_t digits) noexcept;

  /// Counts from one number to another, up or down, by timing and easing: with
  /// kArrive the last wheel takes a fifth of the time for its last step. It
  /// shows 0 for less, and nines for more than the wheels can show.
  void roll(int32_t from,
            int32_t to,
            const Timing& timing,
            const Easing& easing = kArrive) noexcept;

  Rect at(int32_t now_ms) noexcept;
  void draw(const Painter& painter) const noexcept;
  int32_t next_due(int32_t now_ms) const noexcept {
    return motion::next_due(timing_, now_ms);
  }

  uint32_t value() const noexcept {
    return static_cast<uint32_t>(value_q16_ >> 16);
  }
  /// The pixels of all wheels.
  Rect box() const noexcept { return box_of(digits_); }

 private:
  struct Wheel;

  Wheel wheel(int64_t value_q16, int32_t place) const noexcept;
  Rect box_of(int32_t wheels) const noexcept;

  Face face_;
  Point origin_;
  DigitCells cells_;
  int32_t digits_;
  int32_t from_ = 0;
  int32_t to_ = 0;
  Timing timing_;
  Easing easing_;
  int64_t value_q16_ = -1;  // -1: at() was not called
};

}  // namespace inkcell::motion
