// What the decoder of packed glyphs reads from and remembers: prefix codes,
// bits, and the fields that were used last.
#pragma once

#include <stdint.h>

#include "inkcell/format.hpp"
#include "inkcell/packed_codes.hpp"
#include "inkcell/span.hpp"

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
  BitStream() noexcept = default;
  explicit BitStream(Span<const uint8_t> bytes) noexcept
      : next_(bytes.begin()), end_(bytes.end()) {}

  // `width` bits, 16 at most.
  uint32_t number(uint32_t width) noexcept {
    fill();
    const uint32_t value = bits_ >> 1 >> (31 - width);
    drop(width);
    return value;
  }

  // Takes ones, 15 at most, and the bit behind them. 16 if that is a one, too.
  uint32_t ones() noexcept {
    fill();
    uint32_t count = 0;
    uint32_t rest = bits_;
    for (; (rest >> 31) != 0 && count < 16; rest <<= 1) {
      ++count;
    }
    drop(count < 16 ? count + 1 : 16);
    return count;
  }

  // The symbol that comes next, by one of kTables.
  uint32_t symbol(const uint8_t* table, uint32_t max_bits) noexcept {
    fill();
    const uint32_t entry = table[bits_ >> (32 - max_bits)];
    drop(entry & 15);
    return entry >> 4;
  }

  // The byte behind those that have been begun; null if they pass the end.
  const uint8_t* position() const noexcept {
    const uint32_t left = count_ >> 3;
    return left < passed_ ? nullptr : next_ - (left - passed_);
  }

 private:
  // Makes 16 bits available, at least.
  void fill() noexcept {
    if (count_ >= 16) {
      return;
    }
    uint32_t two = 0;
    if (end_ - next_ >= 2) {
      two = uint32_t{next_[0]} << 8 | next_[1];
      next_ += 2;
    } else if (next_ != end_) {
      two = uint32_t{*next_++} << 8;
      passed_ += 1;
    } else {
      passed_ += 2;
    }
    bits_ |= two << (16 - count_);
    count_ += 16;
  }
  void drop(uint32_t width) noexcept {
    bits_ <<= width;
    count_ -= width;
  }

  const uint8_t* next_ = nullptr;
  const uint8_t* end_ = nullptr;
  uint32_t bits_ = 0;    // those to come, from the highest place on
  uint32_t count_ = 0;   // of them
  uint32_t passed_ = 0;  // bytes behind the end that were taken for zeros
};

// The last fields that were used, the latest in front, by where they lie.
class RecentFields {
 public:
  uint32_t size() const noexcept { return size_; }
  uint32_t operator[](uint32_t rank) const noexcept {
    return units_[first_ + rank];
  }
  void clear() noexcept {
    first_ = kRoom;
    size_ = 0;
  }
  // Moves the field at `rank` forward to `place`.
  void move(uint32_t rank, uint32_t place) noexcept {
    uint16_t* const list = units_ + first_;
    const uint16_t unit = list[rank];
    for (; rank > place; --rank) {
      list[rank] = list[rank - 1];
    }
    list[place] = unit;
  }
  // The list grows until `trim` is called; it has room for kRoom.
  void insert(uint32_t unit, uint32_t place) noexcept {
    if (first_ == 0) {
      first_ = kRoom - size_;
      for (uint32_t i = size_; i-- > 0;) {
        units_[first_ + i] = units_[i];
      }
    }
    --first_;
    ++size_;
    uint16_t* const list = units_ + first_;
    for (uint32_t i = 0; i < place; ++i) {
      list[i] = list[i + 1];
    }
    list[place] = static_cast<uint16_t>(unit);
  }
  // Forgets what is too old.
  void trim() noexcept {
    if (size_ > format::packed::kRecentFields) {
      size_ = format::packed::kRecentFields;
    }
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
