#include "inkcell/brush.hpp"

namespace inkcell {
namespace {

// The quotient rounded towards plus infinity; `divisor` is positive.
int32_t divide_up(int32_t dividend, int32_t divisor) noexcept {
  const int32_t towards_zero = dividend / divisor;
  return dividend > towards_zero * divisor ? towards_zero + 1 : towards_zero;
}

}  // namespace

Status Brush::make(Q26_6 size,
                   const Filter& filter,
                   Direction direction,
                   Brush& out) noexcept {
  if (size.raw < kMinSize.raw || size.raw > kMaxSize.raw) {
    return Status::bad_argument;
  }
  const int64_t cosine = direction.cosine.raw;
  const int64_t sine = direction.sine.raw;
  constexpr int64_t kOneQ30 = int64_t{1} << 30;
  const int64_t length_squared =
      ((cosine >> 1) * (cosine >> 1) + (sine >> 1) * (sine >> 1)) >> 28;
  const int64_t excess = length_squared - kOneQ30;
  if (excess > kOneQ30 / 500 || excess < -kOneQ30 / 500) {
    return Status::bad_argument;
  }
  if (sine == 0 && cosine > 0) {
    direction = Direction{};
  }
  // 1024 u over size/64 px, Q16: 2^10 2^6 2^16 / size.
  const int64_t step_q16 = (int64_t{1} << 32) / size.raw;
  Brush brush;
  brush.size_q6_ = size.raw;
  brush.limit_u_q10_ = INT32_MAX / size.raw;
  // Least products of distance and size that reach past the cutoffs: the
  // smallest d with floor(d size / 2^16) > outside is transparent no more.
  brush.transparent_u_q10_ =
      divide_up((filter.outside_q10 + 1) * (1 << 16), size.raw) - 1;
  brush.opaque_u_q10_ = divide_up(filter.inside_q10 * (1 << 16), size.raw);
  brush.step_along_q16_ =
      static_cast<int32_t>((step_q16 * direction.cosine.raw) >> 30);
  brush.step_across_q16_ = static_cast<int32_t>((step_q16 * sine) >> 30);
  int32_t log2 = 2;
  while (64 << log2 < size.raw) {
    ++log2;
  }
  brush.bend_log2_ = static_cast<uint8_t>(log2);
  brush.bend_q14_ =
      static_cast<uint16_t>((int32_t{1} << (14 + 6 + log2)) / size.raw);
  brush.direction_ = direction;
  brush.filter_ = &filter;
  out = brush;
  return Status::ok;
}

}  // namespace inkcell
