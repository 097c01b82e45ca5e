// The ramp of the filter `text`, for sinks that apply it (Sink::ramp).
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell {

/// Four painted bytes, the first one lowest, to coverage. `inside` goes from
/// word to word of a row: all ones if the pixel to the left is inside, 0 at the
/// beginning.
///
/// A byte's bits 1 to 7 are nearness to the edge, 127 on it; bit 0 says that
/// the edge passes between the pixel and the one to the left. Outside coverage
/// is nearness, inside 255 less that: t is bit 0 of each byte and of all
/// before, and the mask of what is inside has 255 for each 1.
inline uint32_t ramp_word(uint32_t bytes, uint32_t& inside) noexcept {
  uint32_t t = bytes & 0x01010101;
  t ^= t << 8;
  t ^= t << 16;
  const uint32_t mask = ((t << 8) - t) ^ inside;
  inside = static_cast<uint32_t>(static_cast<int32_t>(mask) >> 31);
  return (bytes >> 1 & 0x7f7f7f7f) ^ mask;
}

}  // namespace inkcell
