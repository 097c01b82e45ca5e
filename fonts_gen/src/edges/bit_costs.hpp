// What the encoder takes the choices of a cell to cost, in bits.
//
// The tables hold the lengths of prefix codes that were trained on the cells of
// many fonts: what is frequent costs little. They weigh a cell against its
// quarters, and a new field against one that is used again.
#pragma once

#include <algorithm>
#include <cstdint>

namespace inkcell {
namespace gen {

/// Choices for a square.
namespace node_symbol {
inline constexpr int kSplit = 0;
inline constexpr int kOutside = 1;
inline constexpr int kInside = 2;
inline constexpr int kJoin = 3;  // + Join
}  // namespace node_symbol

/// Choices for a field.
namespace kind_symbol {
inline constexpr int kReuse = 0;
inline constexpr int kNew = 1;  // + PrimitiveKind
}  // namespace kind_symbol

/// Fields that a cell may use again: so many were used last.
inline constexpr int kRecentFields = 16;

/// By the size of the square: 256 u and down to 4 u and less.
inline constexpr uint8_t kNodeBits[7][10] = {
    {1, 4, 7, 4, 3, 5, 3, 7, 4, 6}, {2, 4, 7, 2, 2, 5, 4, 7, 4, 6},
    {3, 5, 7, 2, 2, 3, 4, 7, 3, 6}, {3, 4, 7, 2, 2, 3, 5, 7, 3, 6},
    {3, 4, 6, 2, 3, 3, 7, 7, 2, 5}, {4, 7, 7, 2, 3, 2, 7, 7, 2, 5},
    {6, 7, 7, 2, 4, 1, 7, 7, 3, 6}};

/// By the place in the cell, and whether the field before is new. Reused ones
/// come first: behind a new one there is none.
inline constexpr uint8_t kKindBits[6][5] = {{1, 4, 4, 3, 2}, {0, 2, 2, 2, 2},
                                            {1, 4, 4, 3, 2}, {0, 3, 3, 2, 1},
                                            {1, 2, 4, 3, 4}, {0, 3, 3, 2, 1}};

/// Of a reused field's place among the recent ones: of a group's first, of
/// others.
inline constexpr uint8_t kRankBits[2][kRecentFields] = {
    {1, 2, 3, 4, 6, 7, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8},
    {1, 2, 3, 5, 5, 6, 7, 7, 8, 8, 8, 8, 8, 8, 8, 8}};

inline int node_bits(int size_log2, int symbol) {
  return kNodeBits[std::min(6, 8 - size_log2)][symbol];
}
inline int kind_bits(int place, bool after_new, int symbol) {
  return kKindBits[2 * place + (after_new ? 1 : 0)][symbol];
}
inline int rank_bits(bool first_of_group, int step) {
  return kRankBits[first_of_group ? 0 : 1][step];
}

}  // namespace gen
}  // namespace inkcell
