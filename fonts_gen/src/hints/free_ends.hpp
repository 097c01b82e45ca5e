// Ends of strokes in the counters between bars.
#pragma once

#include <vector>

#include "hints/strokes.hpp"

namespace inkcell::gen {

/// The end of a stroke between two bars, such as those of c, e and s.
struct FreeEnd {
  double y = 0;        // [u]
  bool rises = false;  // from below; else it hangs from above
};

/// Finds free ends between two of `bars`, which ascend, and not beside one:
/// convex extremes of the border, ascending.
std::vector<FreeEnd> find_free_ends(const Border& border,
                                    const std::vector<Stroke>& bars);

}  // namespace inkcell::gen
