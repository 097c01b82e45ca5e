// Fields moved to where all the cells that use them are nearest to the truth.
#pragma once

#include <cstddef>

#include "edges/candidates.hpp"
#include "edges/points.hpp"
#include "edges/tree.hpp"

namespace inkcell {
namespace gen {

/// Changes the numbers of the first `count` fields of `tree` and nothing else:
/// squares, joins, kinds and the bits of every code stay, or become fewer. No
/// cell that keeps the limit at its test points loses it, and the sum of the
/// squares of all errors does not grow.
void polish_fields(PointSource& points,
                   const CandidateSource& candidates,
                   size_t count,
                   EdgeTree& tree);

}  // namespace gen
}  // namespace inkcell
