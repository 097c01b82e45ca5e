// Cells of samples as a glyph record (docs/FORMAT.md).
#pragma once

#include "base/byte_writer.hpp"
#include "samples/sample_tree.hpp"

namespace inkcell::gen {

/// `field` has tiles.
Bytes samples_record(const SampleTree& field);

}  // namespace inkcell::gen
