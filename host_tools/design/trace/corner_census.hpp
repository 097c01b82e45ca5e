// Corners of one outline that another one has too.
#pragma once

#include <cstddef>

#include "shape/outline.hpp"

namespace inkcell::design {

struct CornerCensus {
  size_t source = 0;      // corners of more than 20 degrees
  size_t found = 0;       // that the result has within 2 u, above 10 degrees
  size_t false_ones = 0;  // of the result, above 20 degrees, where the source
                          // has none above 10 degrees within 2 u

  void add(const CornerCensus& other);
};

/// The contours of `source` are united first: what lies inside has no corner.
CornerCensus count_corners(const gen::Outline& source,
                           const gen::Outline& result);

}  // namespace inkcell::design
