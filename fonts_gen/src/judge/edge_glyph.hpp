// A glyph of typed cells that keeps the tolerance: encoded, drawn as the device
// draws it, and encoded again where that shows an error.
#pragma once

#include <cstdint>
#include <vector>

#include "edges/tree.hpp"
#include "judge/closed_loop.hpp"
#include "shape/shape.hpp"
#include "target/target.hpp"

namespace inkcell {
namespace gen {

struct EdgeGlyph {
  EdgeTree tree;
  std::vector<uint8_t> record;
  LoopResult errors;  // of this record as drawn
};

/// `shape` must not be empty. `loop_options` say what counts as an error.
///
/// Throws GeometryError::too_complex or too_large if it does not fit.
EdgeGlyph build_edges(const Shape& shape,
                      const Target& options,
                      const LoopOptions& loop_options);

}  // namespace gen
}  // namespace inkcell
