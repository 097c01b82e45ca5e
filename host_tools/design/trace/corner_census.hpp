// Counts corners that two outlines have in common.
#pragma once

#include <cstddef>

#include "shape/outline.hpp"

namespace inkcell::design {

struct CornerCensus {
  size_t source = 0;  // corners of more than 20 degrees
  size_t found = 0;   // of these, in the result within 2 u, above 10 degrees
  size_t false_ones = 0;  // of the result, above 20 degrees, where the source
                          // has none above 10 degrees within 2 u

  void add(const CornerCensus& other);
};

/// Unites the contours of `source` first, as inner ones have no corners.
CornerCensus count_corners(const gen::Outline& source,
                           const gen::Outline& result);

}  // namespace inkcell::design
