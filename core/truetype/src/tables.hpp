// Tables of a TrueType file: big endian, at any address, 0 beyond their end.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"

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

// Numbers that a search compares while `left` bytes of records are left, and
// what a search for a key finds: tables in storage keep some.
inline uint32_t key_at(const Table& table, uint32_t at, uint32_t) noexcept {
  return u16_at(table, at);
}
inline uint32_t wide_key_at(const Table& table,
                            uint32_t at,
                            uint32_t) noexcept {
  return u32_at(table, at);
}
template <typename Find>
static uint32_t found_in(const Table&, uint32_t, const Find& find) noexcept {
  return find();
}

template <typename AnyTable>
static int32_t i16_at(const AnyTable& table, uint32_t at) noexcept {
  return static_cast<int16_t>(u16_at(table, at));
}

// Records of a table, ordered by keys.
struct Records {
  uint32_t first;  // where the first record is
  uint32_t count;
  uint8_t bytes;  // of a record
  uint8_t last;   // where the last key of a record is; the first is at 0
  bool is_wide;   // keys of 32 bits
};

// Where the record of a key is; 0: nowhere.
template <typename AnyTable>
static uint32_t find_record(const AnyTable& table,
                            const Records& in,
                            uint32_t key) noexcept {
  // The record before `low` is the last one that begins at the key or before.
  uint32_t low = 0;
  uint32_t high = in.count;
  while (low < high) {
    const uint32_t middle = (low + high) >> 1;
    const uint32_t at = in.first + in.bytes * middle;
    const uint32_t left = (high - low) * in.bytes;
    if (key <
        (in.is_wide ? wide_key_at(table, at, left) : key_at(table, at, left))) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  const uint32_t at = in.first + in.bytes * (low - 1);
  return low == 0 || key > (in.is_wide ? u32_at(table, at + in.last)
                                       : u16_at(table, at + in.last))
             ? 0
             : at;
}

// Offsets in the record of a glyph.
inline constexpr uint32_t kRecordContours = 0;  // i16; < 0: a composite
inline constexpr uint32_t kRecordBox = 2;       // i16 xMin, yMin, xMax, yMax
inline constexpr uint32_t kRecordBytes = 10;

}  // namespace inkcell::detail
