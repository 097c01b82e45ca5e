// The components of a composite record (docs/FORMAT.md).
#pragma once

#include <stdint.h>

#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"
#include "outlines/record_bits.hpp"

namespace inkcell {
namespace detail {

// Another glyph, moved and mapped:
// x' = xx x + xy y + dx, y' = yx x + yy y + dy.
struct Component {
  uint16_t glyph = 0;
  bool has_matrix = false;
  int32_t dx = 0;  // [font units]
  int32_t dy = 0;
  int32_t matrix_q14[4] = {};  // xx, xy, yx, yy; if there is one
};

// Reads components of any bytes, one for each two bytes of the record at most.
class ComponentReader {
 public:
  constexpr ComponentReader() noexcept = default;
  explicit ComponentReader(Span<const uint8_t> record) noexcept
      : record_(record), has_more_(true) {}

  bool next(Component& out) noexcept {
    if (!has_more_ || bit_ >= 8 * record_.size) {
      return false;
    }
    out.glyph = static_cast<uint16_t>(take(16));
    out.has_matrix = take(1) != 0;
    const uint32_t width = take(4);
    out.dx = take_signed(width);
    out.dy = take_signed(width);
    if (out.has_matrix) {
      for (int32_t& entry : out.matrix_q14) {
        entry = take_signed(16);
      }
    }
    has_more_ = take(1) != 0;
    return true;
  }

 private:
  uint32_t take(uint32_t count) noexcept {
    const uint32_t value = bits_at(record_, bit_, count);
    bit_ += count;
    return value;
  }
  int32_t take_signed(uint32_t count) noexcept {
    const int32_t value = signed_bits_at(record_, bit_, count);
    bit_ += count;
    return value;
  }

  Span<const uint8_t> record_;
  uint32_t bit_ = 8 * format::composite::kTypeBytes;
  bool has_more_ = false;
};

}  // namespace detail
}  // namespace inkcell
