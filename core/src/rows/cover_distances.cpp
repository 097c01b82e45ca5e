// Painted distances to coverage.
#include "rows/cover_distances.hpp"
#include "base/words.hpp"
#include "inkcell/ramp.hpp"

namespace inkcell {
namespace detail {
namespace {

// Four bytes of nearness and bits to coverage of any filter.
uint32_t filtered_word(uint32_t bytes,
                       uint32_t& inside,
                       const Filter& filter,
                       uint32_t step_q8) noexcept {
  uint32_t coverage = 0;
  for (uint32_t shift = 0; shift != 32; shift += 8) {
    const uint32_t byte = bytes >> shift & 255;
    inside ^= 0u - (byte & 1);
    // The middle of the step. [px, Q10]
    const auto distance_q10 =
        static_cast<int32_t>((255 - (byte & 254)) * step_q8 >> 8);
    coverage |=
        uint32_t{filter.coverage(inside != 0 ? distance_q10 : -distance_q10)}
        << shift;
  }
  return coverage;
}

}  // namespace

void cover_filtered(const Band& band, const Filter& filter) noexcept {
  // Half of what a 127th of the reach is. [px, Q18]
  const uint32_t step_q8 = static_cast<uint32_t>(band.reach_q8) * 1024 / 254;
  uint8_t* at = band.bytes;
  const int32_t row_bytes = band.row_bytes();
  const int32_t skipped = band.stride - row_bytes;
  for (int32_t row = 0; row != band.rows; ++row) {
    uint32_t inside = 0;
    for (uint8_t* const end = at + row_bytes; at != end; at += 4) {
      const uint32_t bytes = load_pixels(at);
      if ((bytes | inside) != 0) {
        store_pixels(at, bytes == 0
                             ? inside
                             : filtered_word(bytes, inside, filter, step_q8));
      }
    }
    at += skipped;
  }
}

void cover_linear(const Band& band, const Filter&) noexcept {
  uint8_t* at = band.bytes;
  const int32_t row_bytes = band.row_bytes();
  const int32_t skipped = band.stride - row_bytes;
  for (int32_t row = band.rows; row != 0; --row) {
    uint32_t inside = 0;
    uint8_t* const end = at + row_bytes;
    do {
      const uint32_t bytes = load_pixels(at);
      if (__builtin_expect(bytes == 0, 1)) {
        store_pixels(at, inside);
      } else {
        store_pixels(at, ramp_word(bytes, inside));
      }
      at += 4;
    } while (at != end);
    at += skipped;
  }
}

}  // namespace detail
}  // namespace inkcell
