#include "inkcell/number_text.hpp"

namespace inkcell {
namespace {

constexpr int32_t kMostDecimals = 9;
constexpr int32_t kMostDigits = 10;

int32_t clamped(int32_t value, int32_t least, int32_t most) noexcept {
  return value < least ? least : (value > most ? most : value);
}

// 10 to the power of 0..9.
uint32_t power_of_ten(int32_t exponent) noexcept {
  uint32_t power = 1;
  while (exponent-- > 0) {
    power *= 10;
  }
  return power;
}

uint32_t magnitude(int32_t value) noexcept {
  return value < 0 ? 0u - static_cast<uint32_t>(value)
                   : static_cast<uint32_t>(value);
}

}  // namespace

NumberText::NumberText(int32_t value,
                       int32_t decimals,
                       int32_t digits,
                       char point) noexcept {
  decimals = clamped(decimals, 0, kMostDecimals);
  const uint32_t one = power_of_ten(decimals);
  const uint32_t units = magnitude(value);
  set(value < 0, units / one, units % one, decimals, digits, point);
}

void NumberText::set_fixed(int32_t raw,
                           int32_t fraction_bits,
                           int32_t decimals,
                           int32_t digits,
                           char point) noexcept {
  decimals = clamped(decimals, 0, kMostDecimals);
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
  put(whole, clamped(digits, 1, kMostDigits));
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
