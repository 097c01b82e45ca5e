// What is asked of fonts of edges.
#pragma once

#include "target/target.hpp"

namespace inkcell {
namespace gen {
namespace test {

/// Sizes [px/em] and tolerance [1/255 of coverage].
inline Target edge_target(double min_px, double max_px, double tolerance) {
  Target target;
  target.coding = Coding::edges;
  target.min_px = min_px;
  target.max_px = max_px;
  target.tolerance = tolerance;
  return target;
}

}  // namespace test
}  // namespace gen
}  // namespace inkcell
