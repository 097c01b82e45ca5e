// Cells of primitives as a record (docs/FORMAT.md, "Glyph record, type 2").
#pragma once

#include <cstdint>
#include <vector>

#include "edges/tree.hpp"

namespace inkcell {
namespace gen {

/// The record of a glyph with ink: the narrow form if its numbers fit bytes,
/// else the linked one.
///
/// Throws GeometryError::too_complex if it fits neither.
std::vector<uint8_t> edge_record(const EdgeTree& tree);

}  // namespace gen
}  // namespace inkcell
