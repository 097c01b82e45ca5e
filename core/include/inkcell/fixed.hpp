// Fixed-point numbers whose type says the precision.
//
// Qm.n is signed, m counts the sign bit, m + n is the number of bits stored.
#pragma once

#include <stdint.h>

#include "inkcell/assert.hpp"

namespace inkcell {

/// A signed fixed-point number with `kFraction` fractional bits, stored in
/// `Raw`. Conversions are explicit and loud; arithmetic on raw values stays in
/// inner loops.
template <typename Raw, int kFraction>
struct Fixed {
  Raw raw = 0;

  static constexpr int kFractionBits = kFraction;

  constexpr Fixed() noexcept = default;
  static constexpr Fixed from_raw(Raw value) noexcept {
    Fixed result;
    result.raw = value;
    return result;
  }
  /// `value` must fit the integer part: [-2^(m-1), 2^(m-1)) in Qm.n.
  static constexpr Fixed from_int(Raw value) noexcept {
    INKCELL_ASSERT(
        from_raw(static_cast<Raw>(value * (int64_t{1} << kFraction))).floor() ==
        value);
    return from_raw(static_cast<Raw>(value * (Raw{1} << kFraction)));
  }
  /// Rounds towards minus infinity.
  constexpr Raw floor() const noexcept {
    return static_cast<Raw>(raw >> kFraction);
  }

  friend constexpr bool operator==(Fixed a, Fixed b) noexcept {
    return a.raw == b.raw;
  }
  friend constexpr bool operator!=(Fixed a, Fixed b) noexcept {
    return a.raw != b.raw;
  }
};

/// Sizes and positions at the interface: 1/64 px.
using Q26_6 = Fixed<int32_t, 6>;
/// Signed distances in u (1/1024 em), resolution 1/1024 u.
using Q22_10 = Fixed<int32_t, 10>;
/// Signed distances in px: range +-32 px, resolution 1/1024 px.
using Q6_10 = Fixed<int16_t, 10>;
/// Positions in u (1/1024 em): range +-32 em.
using Q16_16 = Fixed<int32_t, 16>;
/// Components of unit vectors and gradients.
using Q2_14 = Fixed<int16_t, 14>;

namespace detail {

constexpr int32_t clamp(int32_t value, int32_t low, int32_t high) noexcept {
  return value < low ? low : value > high ? high : value;
}

// The number that the characters of a literal are, rounded to 1/64; -1 if they
// are no decimal number below 2^25, with up to 9 digits behind the point.
constexpr int32_t literal_q6(const char* text, int length) noexcept {
  int64_t value = 0;
  int64_t scale = 1;
  bool has_point = false;
  for (int i = 0; i < length; ++i) {
    const char c = text[i];
    if (c == '\'') {
      continue;
    }
    if (c == '.' && !has_point) {
      has_point = true;
      continue;
    }
    if (c < '0' || c > '9' || scale == 1000000000) {
      return -1;
    }
    value = value * 10 + (c - '0');
    scale *= has_point ? 10 : 1;
    if (value / scale >= 1 << 25) {
      return -1;
    }
  }
  return static_cast<int32_t>((value * 64 + scale / 2) / scale);
}

}  // namespace detail

inline namespace literals {

/// Lengths in px: 24_px, 12.5_px; rounded to 1/64 px.
template <char... kCharacters>
constexpr Q26_6 operator""_px() noexcept {
  constexpr char text[] = {kCharacters...};
  constexpr int32_t value_q6 = detail::literal_q6(text, sizeof...(kCharacters));
  static_assert(value_q6 >= 0, "a decimal number below 33554432");
  return Q26_6::from_raw(value_q6);
}

}  // namespace literals

// All arithmetic here relies on it; C++17 leaves it to the implementation.
static_assert((-3 >> 1) == -2, "right shift of a negative number must floor");

}  // namespace inkcell
