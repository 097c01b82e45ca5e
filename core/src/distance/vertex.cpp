#include "distance/vertex.hpp"

namespace inkcell {
namespace detail {

namespace {

// The root rounded down.
__attribute__((always_inline)) inline uint32_t root_of(
    uint32_t value) noexcept {
#if defined(__ARM_FEATURE_IDIV) || defined(__x86_64__)
  if (value == 0) {
    return 0;
  }
  // Newton's steps, from a power of two that is no less: each but the last one
  // leads further down, and none below the root, so that there are few.
  uint32_t result = uint32_t{1} << (16 - (__builtin_clz(value) >> 1));
  while (true) {
    const uint32_t next = (result + value / result) >> 1;
    if (next >= result) {
      return result;
    }
    result = next;
  }
#else
  // Bit by bit.
  uint32_t result = 0;
  uint32_t bit = uint32_t{1} << 30;
  while (bit > value) {
    bit >>= 2;
  }
  for (; bit != 0; bit >>= 2) {
    const uint32_t sum = result + bit;
    result >>= 1;
    if (value >= sum) {
      value -= sum;
      result += bit;
    }
  }
  return result;
#endif
}

__attribute__((always_inline)) inline bool find(int32_t a_q22,
                                                int32_t b_q22,
                                                int32_t c_q14,
                                                Cone& cone) noexcept {
  constexpr int32_t kOneQ14 = 1 << 14;
  constexpr int32_t kMaxCosineQ14 = 16202;
  const uint32_t size =
      0u - static_cast<uint32_t>(a_q22 < b_q22 ? a_q22 : b_q22);
  if (c_q14 > kMaxCosineQ14 || c_q14 < -kMaxCosineQ14) {
    return false;
  }
  int32_t log2 = size >> 8 >= 1u << 12 ? 8 : 0;  // half of the steps at once
  while (size >> log2 >= 1u << 12) {
    ++log2;
  }
  cone.a = a_q22 >> log2;
  cone.b = b_q22 >> log2;
  cone.a_bc_q14 = cone.a * kOneQ14 - c_q14 * cone.b;
  cone.b_ac_q14 = cone.b * kOneQ14 - c_q14 * cone.a;
  cone.c_q14 = c_q14;
  cone.scale_log2 = log2;
  return cone.a_bc_q14 <= 0 && cone.b_ac_q14 <= 0;
}

// |q|: hypot(a, (b - c a) / sqrt(1 - c^2)) [px]
inline int32_t length_q22(const Cone& cone) noexcept {
  const auto sine_q14 =
      root_of(static_cast<uint32_t>((1 << 28) - cone.c_q14 * cone.c_q14));
  // At most 2^13 over 0.148, so that the sum of squares is below 2^32.
  const uint32_t other = static_cast<uint32_t>(-cone.b_ac_q14) / sine_q14;
  const uint32_t length =
      root_of(static_cast<uint32_t>(cone.a * cone.a) + other * other);
  if (length > static_cast<uint32_t>(INT32_MAX) >> cone.scale_log2) {
    return INT32_MAX;
  }
  return static_cast<int32_t>(length << cone.scale_log2);
}

}  // namespace

uint32_t root(uint32_t value) noexcept {
  return root_of(value);
}

bool find_cone(int32_t a_q22,
               int32_t b_q22,
               int32_t c_q14,
               Cone& cone) noexcept {
  return find(a_q22, b_q22, c_q14, cone);
}

int32_t rounded_q22(int32_t lesser_q22,
                    int32_t greater_q22,
                    int32_t c_q14) noexcept {
  Cone cone;
  return find(lesser_q22, greater_q22, c_q14, cone) ? -length_q22(cone)
                                                    : lesser_q22;
}

}  // namespace detail
}  // namespace inkcell
