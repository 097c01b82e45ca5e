// Pair kerning by classes: section KERN, read in place.
#pragma once

#include <stdint.h>

#include "base/bit_table.hpp"
#include "inkcell/span.hpp"

namespace inkcell::detail {

/// KERN as its header describes it.
struct Kerning {
  BitTable members;
  BitTable row_starts;
  BitTable pairs;
  uint32_t pair_count;
  uint32_t member_count;
  uint32_t left_classes;
  uint32_t glyph_bits;
  uint32_t left_bits;
  uint32_t right_bits;
  uint32_t value_bits;

  /// False if the tables do not fit `section`.
  bool open(const Span<const uint8_t>& section) noexcept;

  uint32_t left_class(uint32_t member) const noexcept {
    return members.get(member, glyph_bits, left_bits);
  }
  uint32_t right_class(uint32_t member) const noexcept {
    return members.get(member, glyph_bits + left_bits, right_bits);
  }
  /// The first pair of row `row`, counted from 0.
  uint32_t row_start(uint32_t row) const noexcept {
    return row_starts.get(row, 0, row_starts.row_bits);
  }
};

}  // namespace inkcell::detail
