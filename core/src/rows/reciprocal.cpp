#include "rows/reciprocal.hpp"

#if defined(__ARM_ARCH_6M__)

namespace inkcell::detail {
namespace {

// 2^25 / d - 256, to the nearest, in the middle of each 64th of [2^16, 2^17).
struct Table {
  uint8_t entries[64] = {};

  constexpr Table() noexcept {
    for (uint32_t i = 0; i < 64; ++i) {
      entries[i] =
          static_cast<uint8_t>(((1u << 17) / (2 * (64 + i) + 1) + 1) / 2);
    }
  }
};
constexpr Table kTable;

}  // namespace

Reciprocal reciprocal_of(uint32_t d) noexcept {
  const uint32_t shift = normalize(d);
  const uint32_t rough = 256u + kTable.entries[(d >> 9) - 64];
  const auto error = static_cast<int32_t>((1u << 24) - d * rough);
  const int32_t step = static_cast<int32_t>(rough) * error >> 16;
  uint32_t value = ((rough << 8) + static_cast<uint32_t>(step)) >> 1;
  auto rest = static_cast<int32_t>((1u << 31) - 1 - value * d);
  for (; rest < 0; rest += static_cast<int32_t>(d)) {
    --value;
  }
  for (; rest >= static_cast<int32_t>(d); rest -= static_cast<int32_t>(d)) {
    ++value;
  }
  return {static_cast<int32_t>(value), shift};
}

}  // namespace inkcell::detail

#endif
