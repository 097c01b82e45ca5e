#include "samples/sample_tree.hpp"

#include "samples/forest.hpp"

namespace inkcell {
namespace gen {

AdfGlyph build_adf(const Shape& shape, const AdfOptions& options) {
  if (shape.empty()) {
    return AdfGlyph();
  }
  Forest forest(shape, options);
  forest.grow();
  forest.mend_seams();
  return forest.glyph();
}

}  // namespace gen
}  // namespace inkcell
