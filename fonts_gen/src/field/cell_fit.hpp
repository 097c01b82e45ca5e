// Nine distances that serve a whole cell, where nine samples do not.
#pragma once

#include <array>

#include "field/cell_test.hpp"
#include "shape/shape.hpp"
#include "target/metric.hpp"

namespace inkcell::gen {

/// Changes the nine distances of a cell so that the largest error over it is
/// about as small as it can be: least squares, weighted by what an error costs
/// at each distance, repeated with more weight where the error was large
/// (Lawson's way to the minimum of the maximum). Stops early if `metric`'s
/// limit is met, and after `rounds` at the latest. Knows nothing of
/// quantisation: the result wants a CellTest.
///
/// False if the limit stays out of reach; then `nine` is of no use.
bool fit_cell(const Metric& metric,
              Lattice& lattice,
              const Neighbourhood& truth,
              int rounds,
              std::array<double, 9>& nine);

}  // namespace inkcell::gen
