// A decimal number as text, without printf(), heap or floating point.
//
//   NumberText(235, 1)          "23.5"
//   NumberText(-5, 2)           "-0.05"
//   NumberText(7, 0, 2)         "07"
//   NumberText(Q26_6(...), 1)   of fixed point, rounded
//   NumberText(215, 1).with_unit(" \u00b0C")    "21.5 \u00b0C"
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/text.hpp"

namespace inkcell {

/// Goes wherever a Text goes, and must outlive it.
class NumberText {
 public:
  /// `value` in units of the last decimal. `decimals`: 0 to 9; `digits`: the
  /// fewest before the point, 1 to 10; both are clamped. `point` is the decimal
  /// sign.
  explicit NumberText(int32_t value,
                      int32_t decimals = 0,
                      int32_t digits = 1,
                      char point = '.') noexcept;

  /// Rounded to the nearest decimal, halves away from 0.
  template <typename Raw, int kFraction>
  explicit NumberText(Fixed<Raw, kFraction> value,
                      int32_t decimals = 0,
                      int32_t digits = 1,
                      char point = '.') noexcept {
    set_fixed(value.raw, kFraction, decimals, digits, point);
  }

  /// Puts a unit behind the number, instead of one that is there: 11 bytes at
  /// most, cut after a whole character.
  NumberText& with_unit(Text unit) noexcept;

  Text text() const noexcept {
    return {bytes_ + begin_, static_cast<size_t>(end_ - begin_)};
  }
  operator Text() const noexcept { return text(); }

 private:
  static constexpr size_t kSize = 21;  // a sign, 10 digits, a point, 9 decimals
  static constexpr size_t kMostUnit = 11;

  void set_fixed(int32_t raw,
                 int32_t fraction_bits,
                 int32_t decimals,
                 int32_t digits,
                 char point) noexcept;
  void set(bool is_negative,
           uint32_t whole,
           uint32_t part,
           int32_t decimals,
           int32_t digits,
           char point) noexcept;
  void put(uint32_t number, int32_t least) noexcept;

  char bytes_[kSize + kMostUnit];  // from begin_ to end_
  uint8_t begin_ = kSize;
  uint8_t end_ = kSize;
};

}  // namespace inkcell
