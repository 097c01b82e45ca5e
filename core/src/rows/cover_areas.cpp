// Painted areas to coverage.
#include "rows/cover_areas.hpp"
#include "base/words.hpp"

namespace inkcell {
namespace detail {
namespace {

constexpr uint32_t kEvenBytes = 0x00ff00ff;

// Sums that roundings carry below 0 or above 240, clamped, to coverage.
__attribute__((noinline)) uint32_t clamp_and_scale(uint32_t sums) noexcept {
  uint32_t coverage = 0;
  for (uint32_t shift = 0; shift != 32; shift += 8) {
    uint32_t sum = sums >> shift & 255;
    if (sum > 240) {
      sum = sum > 247 ? 0 : 240;
    }
    coverage |= (sum + (sum >> 4)) << shift;
  }
  return coverage;
}

// Four differences to coverage, 240 units to 255. `sum`: that of all pixels to
// the left, in both halves. Bytes 0 and 2 lie in one word, 1 and 3 in another,
// so that none carries into the next.
inline uint32_t cover_four(uint32_t bytes, uint32_t& sum) noexcept {
  uint32_t even = bytes & kEvenBytes;               // d0, d2
  uint32_t odd = even + (bytes >> 8 & kEvenBytes);  // d0 + d1, d2 + d3
  even += sum;
  even += odd << 16;
  even &= kEvenBytes;
  odd += sum + (odd << 16);
  odd &= kEvenBytes;
  sum = odd >> 16;
  sum |= sum << 16;
  const uint32_t sums = even | odd << 8;
  if (__builtin_expect(
          (((even + 0x000f000f) | (odd + 0x000f000f)) & 0x01000100) != 0, 0)) {
    return clamp_and_scale(sums);
  }
  return sums + (sums >> 4 & 0x0f0f0f0f);
}

}  // namespace

void cover_areas(const Band& band, const Filter&) noexcept {
  uint8_t* at = band.bytes;
  const int32_t row_bytes = band.row_bytes();
  const int32_t skipped = band.stride - row_bytes;
  for (int32_t row = band.rows; row != 0; --row) {
    uint32_t sum = 0;
    uint32_t last = 0;  // the coverage of the pixel before, four times
    uint8_t* const end = at + row_bytes;
    do {
      const uint32_t bytes = load_pixels(at);
      if (__builtin_expect(bytes == 0, 1)) {
        store_pixels(at, last);
      } else {
        const uint32_t coverage = cover_four(bytes, sum);
        last = (coverage >> 24) * 0x01010101u;
        store_pixels(at, coverage);
      }
      at += 4;
    } while (at != end);
    at += skipped;
  }
}

}  // namespace detail
}  // namespace inkcell
