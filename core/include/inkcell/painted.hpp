// From painted words of four pixels to coverage, for sinks that make it while
// they write (Sink::painted). Each row begins with a new object.
#pragma once

#include <stdint.h>

#include "inkcell/cpp17.hpp"

namespace inkcell {

/// Painted::ramp: nearness to the edge, of the filter `text`.
///
/// A byte's bits 1 to 7 are nearness, 127 on the edge; bit 0 says that the edge
/// passes between the pixel and the one to the left. Outside coverage is
/// nearness, inside 255 less that.
struct RampWords {
  /// All ones if the last pixel is inside, else 0.
  uint32_t inside = 0;

  /// The coverage of four pixels whose painted bytes are all 0.
  uint32_t same() const noexcept { return inside; }

  /// That of any four, the first one in the lowest byte. t is bit 0 of each
  /// byte and of all before, and the mask of pixels inside has 255 for each 1.
  uint32_t next(uint32_t bytes) noexcept {
    uint32_t t = bytes & 0x01010101;
    t ^= t << 8;
    t ^= t << 16;
    const uint32_t mask = ((t << 8) - t) ^ inside;
    inside = static_cast<uint32_t>(static_cast<int32_t>(mask) >> 31);
    return (bytes >> 1 & 0x7f7f7f7f) ^ mask;
  }
};

namespace detail {
// Sums that roundings carry below 0 or above 240, clamped, to coverage.
uint32_t clamp_and_scale(uint32_t sums) noexcept;
}  // namespace detail

/// Painted::sums: exact areas.
///
/// A byte is the difference of two pixels' area modulo 256, in 240ths of a
/// pixel.
struct SumWords {
  uint32_t sum = 0;   // of all bytes so far
  uint32_t last = 0;  // the coverage of the last four pixels

  /// As those of RampWords.
  uint32_t same() const noexcept { return (last >> 24) * 0x01010101u; }

  /// Bytes 0 and 2 lie in one word, 1 and 3 in another, so that none carries
  /// into the next.
  uint32_t next(uint32_t bytes) noexcept {
    constexpr uint32_t kEven = 0x00ff00ff;
    uint32_t even = (bytes & kEven) + sum;  // d0, d2
    uint32_t odd = bytes >> 8 & kEven;      // d1, d3
    even += (even + odd) << 16;             // d0, d0 + d1 + d2
    odd = (odd + even) & kEven;
    even &= kEven;
    sum = odd >> 16;
    const uint32_t sums = even | odd << 8;
    last =
        __builtin_expect(
            (((even + 0x000f000f) | (odd + 0x000f000f)) & 0x01000100) != 0, 0)
            ? detail::clamp_and_scale(sums)
            : sums + (sums >> 4 & 0x0f0f0f0f);
    return last;
  }
};

}  // namespace inkcell
