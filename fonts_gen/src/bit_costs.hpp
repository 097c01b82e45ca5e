// What the symbols of the packed coding cost, in bits.
#pragma once

#include <algorithm>

#include "inkcell/packed_codes.hpp"

namespace inkcell {
namespace gen {

/// Symbols of a square.
namespace node_symbol {
inline constexpr int kSplit = 0;
inline constexpr int kOutside = 1;
inline constexpr int kInside = 2;
inline constexpr int kJoin = 3;  // + Join
}  // namespace node_symbol

/// Symbols of a field.
namespace kind_symbol {
inline constexpr int kReuse = 0;
inline constexpr int kNew = 1;  // + FieldKind
}  // namespace kind_symbol

/// Contexts of the prefix codes.
inline int node_context(int size_log2) {
  return std::min(6, 8 - size_log2);
}
inline int kind_context(int place, bool after_new) {
  return 2 * place + (after_new ? 1 : 0);
}
inline int rank_context(bool first_of_group) {
  return first_of_group ? 0 : 1;
}

inline int node_bits(int size_log2, int symbol) {
  return packed_codes::kNodeLengths[node_context(size_log2)][symbol];
}
inline int kind_bits(int place, bool after_new, int symbol) {
  return packed_codes::kKindLengths[kind_context(place, after_new)][symbol];
}
inline int rank_bits(bool first_of_group, int step) {
  return packed_codes::kRankLengths[rank_context(first_of_group)][step];
}

}  // namespace gen
}  // namespace inkcell
