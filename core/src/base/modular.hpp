// Numbers modulo 2^32.
#pragma once

#include <stdint.h>

namespace inkcell::detail {

// Products and sums that may wrap.
inline uint32_t times(int32_t a, uint32_t b) noexcept {
  return static_cast<uint32_t>(a) * b;
}
inline int32_t wrapped(uint32_t value) noexcept {
  return static_cast<int32_t>(value);
}
inline int32_t product(int32_t a, int32_t b) noexcept {
  return wrapped(times(a, static_cast<uint32_t>(b)));
}
inline int32_t sum(int32_t a, int32_t b) noexcept {
  return wrapped(static_cast<uint32_t>(a) + static_cast<uint32_t>(b));
}

}  // namespace inkcell::detail
