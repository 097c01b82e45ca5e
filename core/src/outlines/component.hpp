// The components of a composite record (docs/FORMAT.md).
#pragma once

#include <stdint.h>

#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"
#include "outlines/record_bits.hpp"

namespace inkcell::detail {

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
