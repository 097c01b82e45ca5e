// Cells of nine samples as a glyph record (docs/FORMAT.md).
#pragma once

#include "base/byte_writer.hpp"
#include "field/sample_tree.hpp"

namespace inkcell::gen {

/// `field` has tiles.
Bytes field_record(const SampleTree& field);

}  // namespace inkcell::gen
