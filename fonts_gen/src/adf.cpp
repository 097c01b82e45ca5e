#include "adf.hpp"

#include <algorithm>
#include <cmath>

#include "cell_test.hpp"
#include "forest.hpp"
#include "metric.hpp"

namespace inkcell {
namespace gen {

double band_u(const AdfOptions& options) {
  if (options.predicate == Predicate::fixed) {
    return kFixedBand_u;
  }
  if (options.band_px > 0) {
    return options.band_px * 1024 / options.min_px;
  }
  return (options.coding == Coding::edges ? 512 : 768) / options.min_px;
}

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
