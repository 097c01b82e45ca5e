#include "target/target.hpp"

#include "target/metric.hpp"

namespace inkcell::gen {

double band_u(const Target& options) {
  if (options.predicate == Predicate::fixed) {
    return kFixedBand_u;
  }
  if (options.band_px > 0) {
    return options.band_px * 1024 / options.min_px;
  }
  return 768 / options.min_px;
}

}  // namespace inkcell::gen
