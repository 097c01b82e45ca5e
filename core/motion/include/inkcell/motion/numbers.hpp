// Angles, roots and powers in integers: the same results on every core.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/style.hpp"

namespace inkcell::motion {

/// A part of a turn, counter-clockwise on the screen, 0 to 65535 / 65536. Sums
/// wrap.
using Angle = Fixed<uint16_t, 16>;

/// Any number of degrees, also negative, as an angle.
constexpr Angle from_degrees(int32_t value) noexcept {
  const int32_t wrapped = (value % 360 + 360) % 360;
  return Angle::from_raw(static_cast<uint16_t>((wrapped * 65536 + 180) / 360));
}

/// Error below 1/16000. 1 is returned as 1 - 1/16384, the limit of Q2.14.
Q2_14 sine(Angle angle) noexcept;
/// Likewise.
Q2_14 cosine(Angle angle) noexcept;

/// The unit vector of an angle, exactly {1, 0} at 0. For Style.
Direction direction_of(Angle angle) noexcept;

/// The angle of a vector, y up; 0 for the vector 0. Error below 1/20000 of a
/// turn (Abramowitz and Stegun, 4.4.49).
Angle angle_of(int32_t x, int32_t y) noexcept;

/// The square root, rounded down.
uint32_t square_root(uint64_t value) noexcept;

/// The length of a vector, rounded down, in the units of its components.
uint32_t length_of(int32_t x, int32_t y) noexcept;

/// 2^-x for x >= 0; 0 for x >= 17. Error below 1/65536.
Q16_16 half_to_the(Q16_16 x) noexcept;

/// a + (b - a) progress, rounded to the nearest, clamped to int32_t.
/// Extrapolates outside of 0..1.
int32_t lerp(int32_t a, int32_t b, Q16_16 progress) noexcept;

/// A pseudo-random number that depends only on `seed` and `index`.
uint32_t hash(uint32_t seed, uint32_t index) noexcept;

/// A pseudo-random generator with its state in the caller's struct: PCG, 32
/// bits (O'Neill 2014).
class RandomNumbers {
 public:
  constexpr explicit RandomNumbers(uint32_t seed = 1) noexcept : state_(seed) {}

  uint32_t next() noexcept;
  /// 0 <= result < count; 0 if count is 0.
  uint32_t below(uint32_t count) noexcept {
    return static_cast<uint32_t>(uint64_t{next()} * count >> 32);
  }

 private:
  uint32_t state_;
};

}  // namespace inkcell::motion
