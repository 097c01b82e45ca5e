#include "inkcell/number_text.hpp"

#include "base/math.hpp"

namespace inkcell {
namespace {

using detail::clamp;
using detail::magnitude;

// 10 to the power of `exponent`, which is clamped to 0..9.
uint32_t power_of_ten(int32_t& exponent) noexcept {
  exponent = clamp(exponent, 0, 9);
  uint32_t power = 1;
  for (int32_t i = 0; i < exponent; ++i) {
    power *= 10;
  }
  return power;
}

}  // namespace

NumberText::NumberText(int32_t value,
                       int32_t decimals,
                       int32_t digits,
                       char point) noexcept {
  const uint32_t one = power_of_ten(decimals);
  const uint32_t units = magnitude(value);
  set(value < 0, units / one, units % one, decimals, digits, point);
}

void NumberText::set_fixed(int32_t raw,
                           int32_t fraction_bits,
                           int32_t decimals,
                           int32_t digits,
                           char point) noexcept {
  const uint32_t one = power_of_ten(decimals);
  const uint32_t units = magnitude(raw);
  uint32_t whole = units >> fraction_bits;
  const uint32_t rest = units & ((uint32_t{1} << fraction_bits) - 1);
  const uint64_t half = (uint64_t{1} << fraction_bits) >> 1;
  auto part =
      static_cast<uint32_t>((uint64_t{rest} * one + half) >> fraction_bits);
  if (part == one) {
    ++whole;
    part = 0;
  }
  // Nothing of it may be left.
  set(raw < 0 && (whole | part) != 0, whole, part, decimals, digits, point);
}

void NumberText::set(bool is_negative,
                     uint32_t whole,
                     uint32_t part,
                     int32_t decimals,
                     int32_t digits,
                     char point) noexcept {
  if (decimals != 0) {
    put(part, decimals);
    bytes_[--begin_] = point;
  }
  put(whole, clamp(digits, 1, 10));
  if (is_negative) {
    bytes_[--begin_] = '-';
  }
}

NumberText& NumberText::with_unit(Text unit) noexcept {
  unit = cut(unit, kMostUnit);
  end_ = kSize;
  for (size_t i = 0; i < unit.size; ++i) {
    bytes_[end_++] = unit.data[i];
  }
  return *this;
}

// A number in at least so many digits, in front of what is there.
void NumberText::put(uint32_t number, int32_t least) noexcept {
  while (number != 0 || least > 0) {
    bytes_[--begin_] = static_cast<char>('0' + number % 10);
    number /= 10;
    --least;
  }
}

}  // namespace inkcell
