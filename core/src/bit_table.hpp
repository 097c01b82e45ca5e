// Bit tables: rows of numbers without gaps, read in place within bounds.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"

namespace inkcell {
namespace detail {

/// The `width` bits that begin `bit` bits after the lowest of the first byte.
/// 0 if they leave `bytes` or are wider than format::bit_table::kMaxBits.
uint32_t read_bits(Span<const uint8_t> bytes,
                   uint32_t bit,
                   uint32_t width) noexcept;

/// Rows of `row_bits` bits each. Safe on any bytes: what lies outside is 0.
struct BitTable {
  Span<const uint8_t> bytes;
  uint32_t rows = 0;
  uint32_t row_bits = 0;

  /// Takes a table from the front of `rest`. False if it does not fit there.
  /// `row_count` times `bits` must be below 2^32 - 7.
  bool take(Span<const uint8_t>& rest,
            uint32_t row_count,
            uint32_t bits) noexcept;

  /// The number that begins at bit `bit` of row `row`.
  uint32_t get(uint32_t row, uint32_t bit, uint32_t width) const noexcept {
    return read_bits(bytes, row * row_bits + bit, width);
  }

  /// Of the rows begin <= i < end, ascending by the number in their first
  /// `key_bits` bits: the one where it is `key`, else kAbsent. Binary search.
  uint32_t find(uint32_t begin,
                uint32_t end,
                uint32_t key_bits,
                uint32_t key) const noexcept;

  static constexpr uint32_t kAbsent = 0xffffffff;
};

/// METR behind its header, for `glyph_count` glyphs. False if it does not fit.
bool metrics_table(Span<const uint8_t> section,
                   uint32_t glyph_count,
                   BitTable& out) noexcept;

/// The offsets of GLYF, in units. False if they do not fit.
bool offsets_table(Span<const uint8_t> section,
                   uint32_t glyph_count,
                   BitTable& out) noexcept;

/// KERN as its header describes it.
struct Kerning {
  BitTable members;
  BitTable row_starts;
  BitTable pairs;
  uint16_t left_classes = 0;
  uint16_t right_classes = 0;
  int16_t value_base = 0;
  uint8_t glyph_bits = 0;
  uint8_t left_bits = 0;
  uint8_t right_bits = 0;
  uint8_t value_bits = 0;

  /// False if the tables do not fit `section`.
  bool open(Span<const uint8_t> section) noexcept;

  int32_t value(uint32_t left_glyph, uint32_t right_glyph) const noexcept;
};

}  // namespace detail
}  // namespace inkcell
