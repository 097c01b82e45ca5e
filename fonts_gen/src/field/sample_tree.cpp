#include "field/sample_tree.hpp"

#include "field/forest.hpp"

namespace inkcell::gen {

SampleTree build_sample_tree(const Shape& shape, const Target& options) {
  if (shape.empty()) {
    return SampleTree();
  }
  Forest forest(shape, options);
  forest.grow();
  forest.mend_seams();
  return forest.glyph();
}

}  // namespace inkcell::gen
