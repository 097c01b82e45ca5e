// Bit tables: rows of numbers without gaps, read in place within bounds.
#pragma once

#include <stdint.h>

#include "base/bytes.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/span.hpp"

namespace inkcell::detail {

/// The `width` bits that begin `bit` bits after the lowest of the first byte.
/// 0 if they leave `bytes`, if those are less than four, or if the bits are
/// wider than format::bit_table::kMaxBits.
uint32_t read_any_bits(const Span<const uint8_t>& bytes,
                       uint32_t bit,
                       uint32_t width) noexcept;

/// The same, faster but for numbers near the end.
inline uint32_t read_bits(const Span<const uint8_t>& bytes,
                          uint32_t bit,
                          uint32_t width) noexcept {
#if !defined(__OPTIMIZE_SIZE__)
  const uint32_t first = bit / 8;
  if (width <= format::bit_table::kMaxBits && first + 4 <= bytes.size) {
    return load_any_u32(bytes.data + first) >> bit % 8 &
           ~(~uint32_t{0} << width);
  }
#endif
  return read_any_bits(bytes, bit, width);
}

/// Whether `bits` bits, below 2^32 - 7, fit behind the first `header_bytes` of
/// `section`.
bool bits_fit(const Span<const uint8_t>& section,
              uint32_t header_bytes,
              uint32_t bits) noexcept;

/// Rows of `row_bits` bits each, in bytes that must outlive the table. Safe on
/// any bytes: what lies outside is 0.
struct BitTable {
  const Span<const uint8_t>* bytes;
  uint32_t first_bit;
  uint32_t row_bits;

  /// The number that begins at bit `bit` of row `row`.
  uint32_t get(uint32_t row, uint32_t bit, uint32_t width) const noexcept;

  /// The row, begin <= i < end, whose first `key_bits` bits are `key`, else
  /// kAbsent. Rows ascend by that number: a binary search.
  uint32_t find(uint32_t begin,
                uint32_t end,
                uint32_t key_bits,
                uint32_t key) const noexcept;

  static constexpr uint32_t kAbsent = 0xffffffff;
};

}  // namespace inkcell::detail
