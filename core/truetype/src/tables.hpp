// Tables of a TrueType file: big endian, at any address, 0 beyond their end.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"
#include "inkcell/truetype/truetype_font.hpp"

namespace inkcell::detail {

using Table = Span<const uint8_t>;

// Calls are smaller, and take more time.
#if defined(__OPTIMIZE_SIZE__)
#  define INKCELL_TABLE_READ __attribute__((noinline)) inline
#else
#  define INKCELL_TABLE_READ inline
#endif

INKCELL_TABLE_READ uint32_t u16_at(const Table& table, uint32_t at) noexcept {
  return at < table.size && table.size - at >= 2
             ? uint32_t{table.data[at]} << 8 | table.data[at + 1]
             : 0;
}
INKCELL_TABLE_READ int32_t i16_at(const Table& table, uint32_t at) noexcept {
  return static_cast<int16_t>(u16_at(table, at));
}
INKCELL_TABLE_READ uint32_t u32_at(const Table& table, uint32_t at) noexcept {
  if (at >= table.size || table.size - at < 4) {
    return 0;
  }
  const uint8_t* const from = table.data + at;
  return uint32_t{from[0]} << 24 | uint32_t{from[1]} << 16 |
         uint32_t{from[2]} << 8 | from[3];
}

// What lies from `at` on, and at most `length` of it.
INKCELL_TABLE_READ Table part_of(const Table& table,
                                 uint32_t at,
                                 uint32_t length = UINT32_MAX) noexcept {
  if (at >= table.size) {
    return {};
  }
  const size_t rest = table.size - at;
  return {table.data + at, rest < length ? rest : length};
}

#undef INKCELL_TABLE_READ

// The record of a glyph in `glyf`; empty for a space, and where something does
// not fit.
Table record_of(const TrueTypeFace& face, uint32_t glyph) noexcept;

// Offsets in a record.
inline constexpr uint32_t kRecordContours = 0;  // i16; < 0: a composite
inline constexpr uint32_t kRecordBox = 2;       // i16 xMin, yMin, xMax, yMax
inline constexpr uint32_t kRecordBytes = 10;

// The distance from the origin to the box of a glyph, as `hmtx` has it.
int32_t left_bearing_of(const TrueTypeFace& face, uint32_t glyph) noexcept;

}  // namespace inkcell::detail
