// What the bytes of the section HINT say.
#pragma once

#include <stdint.h>

#include "bytes.hpp"
#include "inkcell/format.hpp"
#include "inkcell/hints.hpp"

namespace inkcell {
namespace detail {

// The level `i` of a table.
inline HintLevel hint_level(const uint8_t* levels, uint32_t i) noexcept {
  const uint32_t bits = load_u16(levels + 2 * i);
  // The sign of 12 bits.
  const auto height = static_cast<int32_t>(bits << 20);
  return {height >> 20, bits >> format::hints::kZoneShift};
}

inline HintEdge hint_edge(uint8_t byte) noexcept {
  return {static_cast<uint8_t>(byte & format::hints::kLevelMask),
          (byte & format::hints::kBar) != 0};
}

}  // namespace detail
}  // namespace inkcell
