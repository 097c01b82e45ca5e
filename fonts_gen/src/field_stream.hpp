// Typed cells in the packed coding (docs/FORMAT.md, "Glyph record, type 3").
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "field_tree.hpp"
#include "inkcell/packed_codes.hpp"

namespace inkcell {
namespace gen {

/// How often each symbol occurs, to make prefix codes of.
struct SymbolCounts {
  uint64_t node[packed_codes::kNodeContexts][packed_codes::kNodeSymbols] = {};
  uint64_t kind[packed_codes::kKindContexts][packed_codes::kKindSymbols] = {};
  uint64_t rank[packed_codes::kRankContexts][packed_codes::kRankSymbols] = {};
};

/// The record of a glyph with ink. Adds to `counts` unless it is null.
std::vector<uint8_t> packed_record(const FieldTree& tree, SymbolCounts* counts);

/// Bytes of the workspace that the device fills when it expands `row_count`
/// rows of tiles from `first_row` on.
size_t expanded_bytes(const FieldTree& tree, int first_row, int row_count);

}  // namespace gen
}  // namespace inkcell
