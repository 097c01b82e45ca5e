// The prefix codes of packed glyphs, as tables to look the next bits up in.
#pragma once

#include <stdint.h>

#include "inkcell/format.hpp"
#include "inkcell/packed_codes.hpp"

namespace inkcell {
namespace detail {

// What nodes' codes are read as: in cells the number of fields and, in the
// lowest bits, the operator.
inline constexpr uint32_t kDivided = 0;
inline constexpr uint32_t kEmpty = 1;     // and 1 if it is inside
inline constexpr uint32_t kLongNode = 3;  // its word is in `long_node`
inline constexpr uint32_t kOperatorBits = 2;
inline constexpr uint32_t kOneField = 1 << kOperatorBits;
inline constexpr uint32_t kTwoFields = 2 << kOperatorBits;
inline constexpr uint32_t kThreeFields = 3 << kOperatorBits;
inline constexpr uint32_t kNested = kThreeFields + 2;  // and above

constexpr uint32_t node_symbol(uint32_t symbol) noexcept {
  using namespace format::packed;
  return symbol >= kMin3     ? kThreeFields + symbol - kMin3
         : symbol >= kMin2   ? kTwoFields + symbol - kMin2
         : symbol == kSingle ? kOneField
                             : symbol;
}
static_assert(node_symbol(format::packed::kSplit) == kDivided &&
                  node_symbol(format::packed::kOutside) == kEmpty &&
                  node_symbol(format::packed::kInside) == kEmpty + 1 &&
                  node_symbol(format::packed::kMinMax) == kNested,
              "ordered like the format's");

// What a field of a cell begins with: one look-up tells the kind of a new one
// or, of nearly all that are used again, the rank, which are the values below.
// The word of a long rank is in `long_rank`, without what told so.
inline constexpr uint32_t kLongRank = packed_codes::kRankSymbols;
inline constexpr uint32_t kNewField = kLongRank + 1;  // and the kind

// A field's context is 2 i + a of the format, and this one for the first of the
// group behind another one.
inline constexpr uint32_t kSecondGroup = 1;
inline constexpr uint32_t kFieldContexts = packed_codes::kKindContexts;
inline constexpr uint32_t kFieldBits = 6;
static_assert(packed_codes::kKindMaxBits <= kFieldBits, "kinds in one look-up");

constexpr uint32_t kind_context(uint32_t context) noexcept {
  return context == kSecondGroup ? 2 : context;
}
constexpr uint32_t rank_context(uint32_t context) noexcept {
  return context <= kSecondGroup ? 0 : 1;
}

// Long words come last in a code: these values of the bits begin with them.
inline constexpr uint32_t kRankValues = 1 << packed_codes::kRankMaxBits;
inline constexpr uint32_t kFirstLongRank = kRankValues - 16;

// Squares of 2^i u have table i.
inline constexpr uint32_t kSquareSizes = format::packed::kTileLog2 + 1;
inline constexpr uint32_t kNodeBits = 6;
inline constexpr uint32_t kNodeValues = 1 << packed_codes::kNodeMaxBits;
inline constexpr uint32_t kFirstLongNode = kNodeValues - 4;
static_assert(packed_codes::kNodeMaxBits == kNodeBits + 1, "one bit to come");

constexpr uint32_t node_context(uint32_t log2) noexcept {
  constexpr uint32_t kDeepest = packed_codes::kNodeContexts - 1;
  const uint32_t level = format::packed::kTileLog2 - log2;
  return level < kDeepest ? level : kDeepest;
}

// Where the symbol is that begins with the next bits, for every value of so
// many bits: symbol << 4 | length of nodes and ranks, symbol << 3 | length of
// fields.
struct NodeTables {
  uint8_t of[kSquareSizes][1 << kNodeBits];
  uint8_t long_node[kSquareSizes][kNodeValues - kFirstLongNode];
  bool complete;  // every value begins with a symbol, which is there
};
struct FieldTables {
  uint8_t of[kFieldContexts][1 << kFieldBits];
  uint8_t long_rank[packed_codes::kRankContexts][kRankValues - kFirstLongRank];
  bool complete;
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

// The code of kinds, with that of ranks behind `reuse`. Returns whether all is
// there.
constexpr bool fill_field_table(uint32_t context,
                                const uint8_t* ranks,
                                uint8_t* table) noexcept {
  using namespace packed_codes;
  uint8_t kinds[1 << kKindMaxBits] = {};
  bool complete = fill_table(kKindLengths[kind_context(context)], kKindSymbols,
                             kKindMaxBits, kinds) == sizeof(kinds);
  for (uint32_t i = 0; i < 1u << kFieldBits; ++i) {
    const uint32_t entry = kinds[i >> (kFieldBits - kKindMaxBits)];
    const uint32_t kind = entry >> 4;
    uint32_t length = entry & 15;
    uint32_t value = kNewField + kind - format::packed::kNew;
    if (kind == format::packed::kReuse) {
      // The bits behind the kind, as the first ones of a rank.
      const uint32_t next = (i << length & ((1u << kFieldBits) - 1)) *
                            (kRankValues >> kFieldBits);
      const uint32_t rank = ranks[next];
      if (length + (rank & 15) <= kFieldBits) {
        value = rank >> 4;
        length += rank & 15;
      } else {
        value = kLongRank;
        complete &= next >= kFirstLongRank;
      }
    }
    table[i] = static_cast<uint8_t>(value << 3 | length);
  }
  return complete;
}

constexpr NodeTables make_node_tables() noexcept {
  using namespace packed_codes;
  NodeTables tables = {};
  tables.complete = true;
  for (uint32_t log2 = 0; log2 < kSquareSizes; ++log2) {
    uint8_t all[kNodeValues] = {};
    tables.complete &=
        fill_table(kNodeLengths[node_context(log2)], kNodeSymbols, kNodeMaxBits,
                   all) == kNodeValues;
    for (uint32_t i = 0; i < kNodeValues; ++i) {
      const uint32_t length = all[i] & 15;
      const auto entry =
          static_cast<uint8_t>(node_symbol(all[i] >> 4u) << 4 | length);
      if (length <= kNodeBits) {
        tables.of[log2][i / 2] = entry;
        continue;
      }
      tables.of[log2][i / 2] = kLongNode << 4;
      if (i < kFirstLongNode) {
        tables.complete = false;
      } else {
        tables.long_node[log2][i - kFirstLongNode] = entry;
      }
    }
  }
  return tables;
}

constexpr FieldTables make_field_tables() noexcept {
  using namespace packed_codes;
  FieldTables tables = {};
  tables.complete = true;
  uint8_t ranks[kRankContexts][kRankValues] = {};
  for (uint32_t i = 0; i < kRankContexts; ++i) {
    tables.complete &= fill_table(kRankLengths[i], kRankSymbols, kRankMaxBits,
                                  ranks[i]) == sizeof(ranks[i]);
    for (uint32_t j = 0; j < kRankValues - kFirstLongRank; ++j) {
      tables.long_rank[i][j] = ranks[i][kFirstLongRank + j];
    }
  }
  for (uint32_t i = 0; i < kFieldContexts; ++i) {
    tables.complete &=
        fill_field_table(i, ranks[rank_context(i)], tables.of[i]);
  }
  return tables;
}

inline constexpr NodeTables kNodeTables = make_node_tables();
inline constexpr FieldTables kFieldTables = make_field_tables();
static_assert(kNodeTables.complete && kFieldTables.complete,
              "any bits must begin with a symbol of a table");

}  // namespace detail
}  // namespace inkcell
