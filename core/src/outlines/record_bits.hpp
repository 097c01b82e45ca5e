// Bits of a record, from the highest of a byte to its lowest, and the
// components of a composite one (docs/FORMAT.md).
#pragma once

#include <stdint.h>

#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"

namespace inkcell::detail {

inline uint32_t load_big_u32(const uint8_t* at) noexcept {
  return uint32_t{at[0]} << 24 | uint32_t{at[1]} << 16 | uint32_t{at[2]} << 8 |
         at[3];
}

// bits_from() where fewer than four bytes are left.
uint32_t last_bits_from(const uint8_t* bytes,
                        uint32_t size,
                        uint32_t first) noexcept;

// The bits from `bit` on, the next one highest: 25 at least, 0 beyond the end.
inline uint32_t bits_from(const uint8_t* bytes,
                          uint32_t size,
                          uint32_t bit) noexcept {
  const uint32_t first = bit >> 3;
  const auto last_four = static_cast<int32_t>(size - 4);
  const uint32_t window =
      __builtin_expect(static_cast<int32_t>(first) <= last_four, 1)
          ? load_big_u32(bytes + first)
          : last_bits_from(bytes, size, first);
  return window << (bit & 7);
}

// `count` bits from `bit` on, 1 to 16; 0 beyond the end.
inline uint32_t bits_at(const Span<const uint8_t>& bytes,
                        uint32_t bit,
                        uint32_t count) noexcept {
  return bits_from(bytes.data, static_cast<uint32_t>(bytes.size), bit) >>
         (32 - count);
}

// Another glyph, moved and mapped:
// x' = xx x + xy y + dx, y' = yx x + yy y + dy.
struct Component {
  uint16_t glyph;
  bool has_matrix;
  // dx, dy; xx, xy, yx, yy, if there is a matrix. [font units; Q14]
  int32_t numbers[6];

  int32_t dx() const noexcept { return numbers[0]; }
  int32_t dy() const noexcept { return numbers[1]; }
  const int32_t* matrix_q14() const noexcept { return numbers + 2; }
};

// Reads components of any bytes, one for each two bytes of the record at most.
class ComponentReader {
 public:
  // Goes to the first component.
  void begin() noexcept { bit_ = 8 * format::composite::kTypeBytes; }

  // The next component of `record`, the same at each call. False: it has no
  // more.
  bool next(const Span<const uint8_t>& record, Component& out) noexcept {
    if (bit_ >= 8 * record.size) {
      return false;
    }
    out.glyph = static_cast<uint16_t>(take(record, 16));
    out.has_matrix = take(record, 1) != 0;
    uint32_t width = take(record, 4);
    const uint32_t count = out.has_matrix ? 6 : 2;
    for (uint32_t i = 0; i != count; ++i) {
      if (i == 2) {
        width = 16;
      }
      // Two's complement.
      const uint32_t sign = 1u << width >> 1;
      out.numbers[i] =
          static_cast<int32_t>((width == 0 ? 0 : take(record, width)) ^ sign) -
          static_cast<int32_t>(sign);
    }
    if (take(record, 1) == 0) {
      bit_ = UINT32_MAX;
    }
    return true;
  }

 private:
  uint32_t take(const Span<const uint8_t>& record, uint32_t count) noexcept {
    const uint32_t value = bits_at(record, bit_, count);
    bit_ += count;
    return value;
  }

  uint32_t bit_;
};

}  // namespace inkcell::detail
