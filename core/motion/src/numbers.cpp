// Trigonometry, roots and powers by polynomials, without tables.
#include "inkcell/motion/numbers.hpp"

#include "base/math.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

using detail::magnitude;

constexpr int32_t kQuarter = 1 << 14;  // of a turn

// sin(pi x / 2) for 0 <= x <= 1. [Q14 -> Q14] A minimax polynomial, within
// 6e-7 before rounding.
int32_t quarter_sine(int32_t x_q14) noexcept {
  const int32_t square = (x_q14 * x_q14 + (1 << 12)) >> 13;  // [Q15]
  int32_t sum = 2603 + ((-142 * square + (1 << 14)) >> 15);
  sum = -21165 + ((sum * square + (1 << 14)) >> 15);
  sum = 51472 + ((sum * square + (1 << 14)) >> 15);  // [Q15], below 2^16
  return (sum * x_q14 + (1 << 14)) >> 15;
}

// atan(x) / (2 pi) for 0 <= x <= 1. [Q15 -> Q16]
int32_t eighth_angle(int32_t x_q15) noexcept {
  const int32_t square = (x_q15 * x_q15) >> 15;
  int32_t sum = -888 + ((217 * square) >> 15);
  sum = 1879 + ((sum * square) >> 15);
  sum = -3445 + ((sum * square) >> 15);
  sum = 10429 + ((sum * square) >> 15);
  return (sum * x_q15 + (1 << 14)) >> 15;
}

}  // namespace

Q2_14 sine(Angle angle) noexcept {
  const int32_t part = angle.raw & (kQuarter - 1);
  const int32_t quarter = angle.raw >> 14;
  const int32_t value =
      quarter_sine((quarter & 1) != 0 ? kQuarter - part : part);
  const int32_t limited = value > INT16_MAX ? INT16_MAX : value;
  return Q2_14::from_raw(
      static_cast<int16_t>((quarter & 2) != 0 ? -limited : limited));
}

Q2_14 cosine(Angle angle) noexcept {
  return sine(Angle::from_raw(static_cast<uint16_t>(angle.raw + kQuarter)));
}

Direction direction_of(Angle angle) noexcept {
  return {Fixed<int32_t, 30>::from_raw(cosine(angle).raw * (1 << 16)),
          Fixed<int32_t, 30>::from_raw(sine(angle).raw * (1 << 16))};
}

Angle angle_of(int32_t x, int32_t y) noexcept {
  uint32_t along = magnitude(x);
  uint32_t across = magnitude(y);
  const bool is_steep = across > along;
  const uint32_t most = is_steep ? across : along;
  if (most == 0) {
    return {};
  }
  // The lesser over the greater needs 15 bits of headroom.
  uint32_t shift = 0;
  while ((most >> shift) > 0xffff) {
    ++shift;
  }
  along >>= shift;
  across >>= shift;
  const uint32_t ratio_q15 =
      is_steep ? (along << 15) / across : (across << 15) / along;
  int32_t angle = eighth_angle(static_cast<int32_t>(ratio_q15));
  angle = is_steep ? kQuarter - angle : angle;
  angle = x < 0 ? 2 * kQuarter - angle : angle;
  angle = y < 0 ? -angle : angle;
  return Angle::from_raw(static_cast<uint16_t>(angle));
}

uint32_t square_root(uint64_t value) noexcept {
  return detail::root_of(value);
}

uint32_t length_of(int32_t x, int32_t y) noexcept {
  const uint64_t along = magnitude(x);
  const uint64_t across = magnitude(y);
  return square_root(along * along + across * across);
}

Q16_16 half_to_the(Q16_16 x) noexcept {
  const int32_t whole = x.raw >> 16;
  if (x.raw <= 0) {
    return Q16_16::from_int(1);
  }
  if (whole > 16) {
    return {};
  }
  // 2^-f = 1 - f / 2 - f (1 - f) (0.19307 - 0.04643 f + 0.00685 f^2)
  const int32_t f_q15 = (x.raw & 0xffff) >> 1;
  const int32_t bend_q15 =
      6327 - ((1521 * f_q15 - ((224 * f_q15 >> 15) * f_q15)) >> 15);
  const int32_t arch_q15 = (f_q15 * ((1 << 15) - f_q15)) >> 15;
  const int32_t power_q16 =
      65536 - (x.raw & 0xffff) / 2 - ((arch_q15 * bend_q15 + (1 << 13)) >> 14);
  return Q16_16::from_raw(
      whole == 0 ? power_q16 : (power_q16 + (1 << (whole - 1))) >> whole);
}

int32_t lerp(int32_t a, int32_t b, Q16_16 progress) noexcept {
  // At most 2^32 2^31 and 2^31: 64 bits hold it.
  const int64_t step = (int64_t{b} - a) * progress.raw;
  const int64_t sum = a + ((step + (1 << 15)) >> 16);
  return clamp_i64(sum, INT32_MIN, INT32_MAX);
}

uint32_t hash(uint32_t seed, uint32_t index) noexcept {
  RandomNumbers numbers(seed ^ (index * 0x9e3779b9u));
  numbers.next();
  return numbers.next();
}

uint32_t RandomNumbers::next() noexcept {
  state_ = state_ * 747796405u + 2891336453u;
  const uint32_t word =
      ((state_ >> ((state_ >> 28) + 4)) ^ state_) * 277803737u;
  return (word >> 22) ^ word;
}

}  // namespace inkcell::motion
