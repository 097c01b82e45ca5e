#include "field/forest.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "field/cell_fit.hpp"
#include "inkcell/field/glyph_field.hpp"

namespace inkcell::gen {
namespace {

// Nine samples that miss the limit by more than this cannot be mended by a fit:
// one in two hundred could.
constexpr double kFitReach = 3;

// Rounds of the fit.
constexpr int kRoundsPerEffort = 2;

// What a saturated cell reads as. [u]
constexpr double kSaturated_u = kSaturatedDistanceQ10 / 1024.0;

constexpr uint32_t kNone = UINT32_MAX;

// Sides of a square, and the step across each.
constexpr int kSides = 4;
constexpr int kStepX[kSides] = {-1, 1, 0, 0};
constexpr int kStepY[kSides] = {0, 0, -1, 1};

// Points of a side at which two cells are compared.
constexpr int kSeamSteps = 16;

[[noreturn]] void throw_too_complex(const char* what) {
  throw GeometryError(GeometryError::Kind::too_complex, what);
}

}  // namespace

Forest::Forest(const Shape& shape, const Target& options)
    : shape_(shape),
      metric_(options),
      test_(metric_, options.predicate == Predicate::size_aware),
      grid_(lay_grid(shape, options)),
      size_aware_(options.predicate == Predicate::size_aware),
      fit_rounds_(size_aware_ ? kRoundsPerEffort * options.effort : 0) {
  for (const CellSquare& tile : tiles_of(grid_)) {
    trees_.emplace_back();
    trees_.back().square = tile;
  }
}

void Forest::grow() {
  const uint32_t tiles = static_cast<uint32_t>(trees_.size());
  for (uint32_t i = 0; i < tiles; ++i) {
    const CellSquare square = trees_[i].square;
    grow(i, Neighbourhood(shape_, square.square()), Lattice(square));
  }
}

void Forest::grow(uint32_t at, const Neighbourhood& truth, Lattice lattice) {
  Tree& tree = trees_[at];
  if (truth.clearance() >= metric_.band_u()) {
    tree.kind = lattice.nine(truth)[4] > 0 ? Kind::inside : Kind::outside;
    return;
  }
  if (settle(tree, truth, lattice)) {
    tree.kind = Kind::cell;
    if (++cell_count_ > format::glyph::kMaxCells) {
      throw_too_complex("the glyph needs more than 32768 cells");
    }
    return;
  }
  divide(at, truth, lattice);
}

void Forest::divide(uint32_t at,
                    const Neighbourhood& truth,
                    const Lattice& lattice) {
  const uint32_t first = static_cast<uint32_t>(trees_.size());
  const CellSquare square = trees_[at].square;
  trees_[at].kind = Kind::node;
  trees_[at].children = first;
  trees_.resize(trees_.size() + 4);
  for (int i = 0; i < 4; ++i) {
    const uint32_t child = first + static_cast<uint32_t>(i);
    trees_[child].square = square.child(i);
    grow(child, truth.part(trees_[child].square.square()), lattice.child(i));
  }
}

// Whether the square can stay whole; then its cell and verdict are set.
bool Forest::settle(Tree& tree,
                    const Neighbourhood& truth,
                    Lattice& lattice) const {
  const int log2 = tree.square.size_log2;
  if (log2 > kLargestCellLog2) {
    return false;
  }
  const std::array<double, 9> nine = lattice.nine(truth);
  tree.cell = quantise(nine, log2);
  tree.tested = metric_.tests_cell(nine[4], log2);
  if (!tree.tested) {
    return true;
  }
  if (log2 <= metric_.smallest_log2()) {
    tree.verdict = test_.measure(tree.cell, lattice, truth);
    return true;
  }
  tree.verdict = test_.run(tree.cell, lattice, truth);
  if (tree.verdict.passed || fit_rounds_ == 0 ||
      tree.verdict.worst > kFitReach * metric_.limit()) {
    return tree.verdict.passed;
  }
  std::array<double, 9> fitted = nine;
  if (!fit_cell(metric_, lattice, truth, fit_rounds_, fitted)) {
    return false;
  }
  tree.cell = quantise(fitted, log2);
  tree.verdict = test_.run(tree.cell, lattice, truth);
  return tree.verdict.passed;
}

// The leaf that holds (x, y) and the u to its upper right; kNone outside.
uint32_t Forest::leaf_at(int x_u, int y_u) const {
  const int x = x_u - grid_.x0_u;
  const int y = y_u - grid_.y0_u;
  if (x < 0 || y < 0 || x >= grid_.tiles_x << grid_.tile_log2 ||
      y >= grid_.tiles_y << grid_.tile_log2) {
    return kNone;
  }
  uint32_t at = static_cast<uint32_t>((y >> grid_.tile_log2) * grid_.tiles_x +
                                      (x >> grid_.tile_log2));
  while (trees_[at].kind == Kind::node) {
    const int half = trees_[at].square.size_log2 - 1;
    const int child = ((y >> half) & 1) * 2 + ((x >> half) & 1);
    at = trees_[at].children + static_cast<uint32_t>(child);
  }
  return at;
}

double Forest::read(const Tree& leaf, double x_u, double y_u) const {
  if (leaf.kind != Kind::cell) {
    return leaf.kind == Kind::inside ? kSaturated_u : -kSaturated_u;
  }
  return read_cell(leaf.cell, leaf.square.size_log2, x_u - leaf.square.x_u,
                   y_u - leaf.square.y_u);
}

// Compares `a` with `b`, which is at least as wide, all along that side of `a`.
double Forest::jump(const Tree& a, const Tree& b, int side) const {
  const double size = a.square.size_u();
  double worst = 0;
  for (int k = 0; k <= kSeamSteps; ++k) {
    const double along = size * k / kSeamSteps;
    const double x =
        a.square.x_u +
        (kStepX[side] == 0 ? along : (kStepX[side] > 0 ? size : 0.0));
    const double y =
        a.square.y_u +
        (kStepY[side] == 0 ? along : (kStepY[side] > 0 ? size : 0.0));
    worst = std::max(worst, metric_.error(read(a, x, y), read(b, x, y)));
  }
  return worst;
}

// The cell to divide if the seam on that side of `at` jumps too far: the wider
// one, or of equals the one that is less true. kNone if all is well, nothing
// can be done, or the neighbour is narrower (it sees the same seam).
uint32_t Forest::weaker_at_seam(uint32_t at, int side) const {
  const Tree& a = trees_[at];
  const int size = a.square.size_u();
  const int x = a.square.x_u + (kStepX[side] > 0 ? size : kStepX[side]);
  const int y = a.square.y_u + (kStepY[side] > 0 ? size : kStepY[side]);
  const uint32_t other = leaf_at(x, y);
  if (other == kNone || trees_[other].square.size_log2 < a.square.size_log2) {
    return kNone;
  }
  const Tree& b = trees_[other];
  if (jump(a, b, side) <= metric_.tolerance()) {
    return kNone;
  }
  const bool wider = b.square.size_log2 > a.square.size_log2;
  const bool less_true = b.verdict.worst > a.verdict.worst;
  for (const uint32_t weak : wider || less_true
                                 ? std::array<uint32_t, 2>{other, at}
                                 : std::array<uint32_t, 2>{at, other}) {
    if (trees_[weak].kind == Kind::cell &&
        trees_[weak].square.size_log2 > metric_.smallest_log2()) {
      return weak;
    }
  }
  return kNone;
}

void Forest::mend_seams() {
  if (!size_aware_) {
    return;
  }
  // Every round divides cells above the smallest size, so the rounds end.
  std::set<uint32_t> weak;
  do {
    weak.clear();
    for (uint32_t at = 0; at < trees_.size(); ++at) {
      for (int side = 0; trees_[at].kind == Kind::cell && side < kSides;
           ++side) {
        const uint32_t found = weaker_at_seam(at, side);
        if (found != kNone) {
          weak.insert(found);
        }
      }
    }
    for (const uint32_t at : weak) {
      const CellSquare square = trees_[at].square;
      --cell_count_;
      divide(at, Neighbourhood(shape_, square.square()), Lattice(square));
    }
  } while (!weak.empty());
}

// Appends the tree `at` and returns the reference to it.
uint16_t Forest::write(uint32_t at, int level, SampleTree& glyph) const {
  namespace refs = format::glyph;
  const Tree& tree = trees_[at];
  glyph.depth = std::max(glyph.depth, level);
  switch (tree.kind) {
    case Kind::outside:
      return refs::kOutside;
    case Kind::inside:
      return refs::kInside;
    case Kind::cell:
      glyph.cells.push_back(tree.cell);
      glyph.worst_error = std::max(glyph.worst_error, tree.verdict.worst);
      return static_cast<uint16_t>(refs::kCellFlag | (glyph.cells.size() - 1));
    case Kind::node:
      break;
  }
  const size_t first = glyph.references.size();
  const size_t node = static_cast<size_t>(glyph.node_count());
  if (node >= refs::kMaxNodes) {
    throw_too_complex("the glyph needs more than 32766 nodes");
  }
  glyph.references.resize(first + 4);
  for (uint32_t i = 0; i < 4; ++i) {
    const uint16_t child = write(tree.children + i, level + 1, glyph);
    glyph.references[first + i] = child;
  }
  return static_cast<uint16_t>(refs::kFirstNode + node);
}

double Forest::mean_error() const {
  double sum = 0;
  double area = 0;
  for (const Tree& tree : trees_) {
    if (tree.kind == Kind::cell && tree.tested) {
      const double cell_area = std::ldexp(1.0, 2 * tree.square.size_log2);
      sum += cell_area * tree.verdict.mean;
      area += cell_area;
    }
  }
  return area > 0 ? sum / area : 0;
}

SampleTree Forest::glyph() const {
  SampleTree glyph;
  glyph.tile_log2 = grid_.tile_log2;
  glyph.x0_u = grid_.x0_u;
  glyph.y0_u = grid_.y0_u;
  glyph.tiles_x = grid_.tiles_x;
  glyph.tiles_y = grid_.tiles_y;
  const uint32_t tiles = static_cast<uint32_t>(grid_.tiles_x * grid_.tiles_y);
  glyph.references.resize(tiles);
  for (uint32_t i = 0; i < tiles; ++i) {
    const uint16_t tile = write(i, 0, glyph);
    glyph.references[i] = tile;
  }
  glyph.mean_error = mean_error();
  glyph.within_tolerance = glyph.worst_error <= metric_.tolerance();
  return glyph;
}

}  // namespace inkcell::gen
