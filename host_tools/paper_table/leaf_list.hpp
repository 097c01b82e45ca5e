// A field as the paper stores it: a list of leaves, 15 bytes each.
#pragma once

#include <cstdint>
#include <vector>

#include "field/sample_tree.hpp"

namespace inkcell::tools {

/// The paper's section 3.3.1: for each leaf that is not constant x and y (2
/// bytes each), level (1), distance at the centre (2), eight offsets (1 each);
/// in the order of a walk through the quadtree.
std::vector<uint8_t> leaf_list(const gen::SampleTree& glyph);

/// Bytes that zlib at its best makes of them.
size_t compressed_bytes(const std::vector<uint8_t>& bytes);

}  // namespace inkcell::tools
