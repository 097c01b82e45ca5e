#include "field/paper_counts.hpp"

#include <cmath>

#include "field/cell_test.hpp"
#include "field/forest.hpp"
#include "target/metric.hpp"

namespace inkcell::gen {
namespace {

// Lagrange weights of the points 0 and 1, or 0, 1/2 and 1.
std::array<double, 3> weights(double t, int order) {
  if (order == 1) {
    return {1 - t, 0, t};
  }
  return {2 * (t - 0.5) * (t - 1), -4 * t * (t - 1), 2 * t * (t - 0.5)};
}

double interpolate(const std::array<double, 9>& nine,
                   int order,
                   double x,
                   double y) {
  const std::array<double, 3> wx = weights(x, order);
  const std::array<double, 3> wy = weights(y, order);
  double sum = 0;
  for (size_t k = 0; k < 9; ++k) {
    sum += wx[k % 3] * wy[k / 3] * nine[k];
  }
  return sum;
}

// Counts the leaves of an ADF that interpolates with polynomials of `order`.
class AdfCounter {
 public:
  AdfCounter(const Target& options, int order, Scope scope)
      : metric_(options), order_(order), scope_(scope) {}

  void count(const CellSquare& square,
             const Neighbourhood& truth,
             Lattice lattice,
             LeafCounts& counts) const {
    if (truth.clearance() >= metric_.band_u()) {
      ++counts.all;
      return;
    }
    if (passes(truth, lattice)) {
      ++counts.all;
      ++counts.varying;
      return;
    }
    for (int i = 0; i < 4; ++i) {
      const CellSquare child = square.child(i);
      count(child, truth.part(child.square()), lattice.child(i), counts);
    }
  }

 private:
  bool passes(const Neighbourhood& truth, Lattice& lattice) const {
    const int log2 = lattice.cell().size_log2;
    if (log2 > kLargestCellLog2) {
      return false;
    }
    const std::array<double, 9> nine = lattice.nine(truth);
    return log2 <= metric_.smallest_log2() ||
           (scope_ == Scope::edge && !metric_.tests_cell(nine[4], log2)) ||
           good_enough(nine, truth, lattice);
  }

  bool good_enough(const std::array<double, 9>& nine,
                   const Neighbourhood& truth,
                   Lattice& lattice) const {
    for (int stride = 4; stride >= 1; stride /= 2) {
      for (int j = 0; j <= Lattice::kSteps; j += stride) {
        lattice.fill_row(truth, j, stride);
        for (int i = 0; i <= Lattice::kSteps; i += stride) {
          const double value = interpolate(
              nine, order_, static_cast<double>(i) / Lattice::kSteps,
              static_cast<double>(j) / Lattice::kSteps);
          if (metric_.error(lattice(i, j), value) > metric_.limit()) {
            return false;
          }
        }
      }
    }
    return true;
  }

  Metric metric_;
  int order_;
  Scope scope_;
};

LeafCounts count_cells(const Shape& shape,
                       const Target& options,
                       int order,
                       Scope scope) {
  LeafCounts counts;
  if (shape.empty()) {
    return counts;
  }
  const AdfCounter counter(options, order, scope);
  for (const CellSquare& tile : tiles_of(lay_grid(shape, options))) {
    counter.count(tile, Neighbourhood(shape, tile.square()), Lattice(tile),
                  counts);
  }
  return counts;
}

void count_colours(const Square& square,
                   const Neighbourhood& truth,
                   double smallest_u,
                   LeafCounts& counts) {
  if (truth.clearance() > 0) {
    ++counts.all;
    return;
  }
  if (square.size <= smallest_u) {
    ++counts.all;
    ++counts.varying;
    return;
  }
  const double half = square.size / 2;
  for (int i = 0; i < 4; ++i) {
    const Square child{square.x + (i & 1) * half, square.y + (i >> 1) * half,
                       half};
    count_colours(child, truth.part(child), smallest_u, counts);
  }
}

}  // namespace

LeafCounts count_cells_bilinear(const Shape& shape,
                                const Target& options,
                                Scope scope) {
  return count_cells(shape, options, 1, scope);
}

LeafCounts count_cells_biquadratic(const Shape& shape,
                                   const Target& options,
                                   Scope scope) {
  return count_cells(shape, options, 2, scope);
}

LeafCounts count_cells_three_colour(const Shape& shape, int resolution) {
  LeafCounts counts;
  if (shape.empty()) {
    return counts;
  }
  Target root;
  root.predicate = Predicate::fixed;
  for (const CellSquare& tile : tiles_of(lay_grid(shape, root))) {
    count_colours(tile.square(), Neighbourhood(shape, tile.square()),
                  1024.0 / resolution, counts);
  }
  return counts;
}

}  // namespace inkcell::gen
