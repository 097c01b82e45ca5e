// What the decoder of packed glyphs reads from and remembers: prefix codes,
// bits, and the fields that were used last.
#pragma once

#include <stdint.h>

#include "inkcell/format.hpp"
#include "inkcell/packed_codes.hpp"

namespace inkcell {
namespace detail {

// Where the symbol is that begins with the next bits: symbol << 4 | length, for
// every value of as many bits as the longest code has.
struct CodeTables {
  uint8_t node[packed_codes::kNodeContexts][1 << packed_codes::kNodeMaxBits];
  uint8_t kind[packed_codes::kKindContexts][1 << packed_codes::kKindMaxBits];
  uint8_t rank[packed_codes::kRankContexts][1 << packed_codes::kRankMaxBits];
  bool complete;  // every value begins with a symbol
};

// Ascending by length, then by symbol, codes take up one part of the table
// after the other. Returns the size of all parts.
constexpr uint32_t fill_table(const uint8_t* lengths,
                              uint32_t symbols,
                              uint32_t max_bits,
                              uint8_t* table) noexcept {
  uint32_t end = 0;
  for (uint32_t length = 1; length <= max_bits; ++length) {
    for (uint32_t symbol = 0; symbol < symbols; ++symbol) {
      if (lengths[symbol] != length) {
        continue;
      }
      for (uint32_t i = 0; i < 1u << (max_bits - length); ++i) {
        table[end++] = static_cast<uint8_t>(symbol << 4 | length);
      }
    }
  }
  return end;
}

constexpr CodeTables make_tables() noexcept {
  CodeTables tables = {};
  tables.complete = true;
  for (uint32_t i = 0; i < packed_codes::kNodeContexts; ++i) {
    tables.complete &=
        fill_table(packed_codes::kNodeLengths[i], packed_codes::kNodeSymbols,
                   packed_codes::kNodeMaxBits,
                   tables.node[i]) == sizeof(tables.node[i]);
  }
  for (uint32_t i = 0; i < packed_codes::kKindContexts; ++i) {
    tables.complete &=
        fill_table(packed_codes::kKindLengths[i], packed_codes::kKindSymbols,
                   packed_codes::kKindMaxBits,
                   tables.kind[i]) == sizeof(tables.kind[i]);
  }
  for (uint32_t i = 0; i < packed_codes::kRankContexts; ++i) {
    tables.complete &=
        fill_table(packed_codes::kRankLengths[i], packed_codes::kRankSymbols,
                   packed_codes::kRankMaxBits,
                   tables.rank[i]) == sizeof(tables.rank[i]);
  }
  return tables;
}

inline constexpr CodeTables kTables = make_tables();
static_assert(kTables.complete, "any bits must begin with a symbol");

// Bits of a stream, the first in the highest place of a byte; zeros behind its
// end.
class BitStream {
 public:
  BitStream(const uint8_t* data, uint32_t size) noexcept
      : data_(data), size_(size) {}

  // `width` bits, 16 at most.
  uint32_t number(uint32_t width) noexcept {
    fill();
    const uint32_t value = bits_ >> 1 >> (31 - width);
    drop(width);
    return value;
  }

  // The symbol that comes next, by one of kTables.
  uint32_t symbol(const uint8_t* table, uint32_t max_bits) noexcept {
    fill();
    const uint32_t entry = table[bits_ >> (32 - max_bits)];
    drop(entry & 15);
    return entry >> 4;
  }

  // Bytes that have been begun.
  uint32_t used() const noexcept { return at_ - (count_ >> 3); }

 private:
  void fill() noexcept {
    if (count_ >= 16) {
      return;
    }
    do {
      const uint32_t byte = at_ < size_ ? data_[at_] : 0u;
      ++at_;
      bits_ |= byte << (24 - count_);
      count_ += 8;
    } while (count_ <= 24);
  }
  void drop(uint32_t width) noexcept {
    bits_ <<= width;
    count_ -= width;
  }

  const uint8_t* data_;
  uint32_t size_;
  uint32_t at_ = 0;     // the byte to read next, or how far behind the end
  uint32_t bits_ = 0;   // those to come, from the highest place on
  uint32_t count_ = 0;  // of them
};

// The last fields that were used, the latest in front, by where they lie.
class RecentFields {
 public:
  uint32_t size() const noexcept { return size_; }
  void clear() noexcept {
    first_ = kRoom;
    size_ = 0;
  }
  uint16_t operator[](uint32_t rank) const noexcept {
    return units_[first_ + rank];
  }
  // A field that is not there.
  void insert(uint32_t unit) noexcept {
    if (first_ == 0) {
      first_ = kRoom - size_;
      for (uint32_t i = size_; i-- > 0;) {
        units_[first_ + i] = units_[i];
      }
    }
    units_[--first_] = static_cast<uint16_t>(unit);
    ++size_;
  }
  // Forgets the oldest. A leaf inserts no more than three fields before.
  void trim() noexcept {
    if (size_ > format::packed::kRecentFields) {
      size_ = format::packed::kRecentFields;
    }
  }
  // A field that is.
  void move_to_front(uint32_t unit) noexcept {
    uint16_t* at = units_ + first_;
    auto moved = static_cast<uint16_t>(unit);
    do {
      const uint16_t next = *at;
      *at++ = moved;
      moved = next;
    } while (moved != unit);
  }

 private:
  // Twice as many as are kept, so that few of all insertions must move them.
  static constexpr uint32_t kRoom = 2 * format::packed::kRecentFields;

  uint16_t units_[kRoom];
  uint32_t first_ = kRoom;
  uint32_t size_ = 0;
};

}  // namespace detail
}  // namespace inkcell
