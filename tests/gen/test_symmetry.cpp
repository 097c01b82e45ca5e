// Reflected and turned fields, against fields of reflected and turned outlines.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "field/cell_test.hpp"
#include "field/record.hpp"
#include "field/symmetry.hpp"
#include "glyph_outlines.hpp"
#include "inkcell/field/cell.hpp"
#include "shape/neighbourhood.hpp"

namespace inkcell::gen::test {
namespace {

constexpr Symmetry kAll[] = {{1, 0, 0, 1},   {-1, 0, 0, 1}, {1, 0, 0, -1},
                             {-1, 0, 0, -1}, {0, 1, 1, 0},  {0, -1, 1, 0},
                             {0, 1, -1, 0},  {0, -1, -1, 0}};
constexpr Symmetry kQuarter = {0, -1, 1, 0};

Outline mapped(Outline outline, const Symmetry& s) {
  for (Contour& contour : outline.contours) {
    for (Segment& segment : contour.segments) {
      for (Point& p : segment.p) {
        p = {s.xx * p.x + s.xy * p.y, s.yx * p.x + s.yy * p.y};
      }
    }
  }
  return outline;
}

// Shapes of lines, curves and counters, for the paper's and for the generator's
// own trees.
std::vector<Outline> shapes() {
  std::vector<Outline> result =
      load_outlines(kLiberationSerif, 0, {'a', 'R', '&', '%'});
  result.push_back(load_outlines(kRoboto, 0, {'g'})[0]);
  return result;
}

std::vector<Target> targets() {
  std::vector<Target> result(3);
  result[1].effort = 0;  // nine samples, never fitted
  result[2].predicate = Predicate::fixed;
  return result;
}

struct Leaf {
  CellSquare square;
  uint16_t reference;
};

void add_leaves(const SampleTree& tree,
                uint16_t reference,
                const CellSquare& square,
                std::vector<Leaf>& leaves) {
  namespace refs = format::glyph;
  if ((reference & refs::kCellFlag) != 0 || reference < refs::kFirstNode) {
    leaves.push_back({square, reference});
    return;
  }
  const size_t first = static_cast<size_t>(tree.tiles_x * tree.tiles_y) +
                       4 * static_cast<size_t>(reference - refs::kFirstNode);
  for (int child = 0; child < 4; ++child) {
    add_leaves(tree, tree.references[first + static_cast<size_t>(child)],
               square.child(child), leaves);
  }
}

std::vector<Leaf> leaves_of(const SampleTree& tree) {
  const Grid grid = {tree.tile_log2, tree.x0_u, tree.y0_u, tree.tiles_x,
                     tree.tiles_y};
  std::vector<Leaf> leaves;
  size_t tile = 0;
  for (const CellSquare& square : tiles_of(grid)) {
    add_leaves(tree, tree.references[tile++], square, leaves);
  }
  return leaves;
}

std::array<double, 9> nine_of(const CellSquare& square, const Shape& shape) {
  return Lattice(square).nine(Neighbourhood(shape, square.square()));
}

// Counts samples of a cell that differ from those of `shape`, except where the
// last bit of a double decides between two steps that are equally near.
int wrong_samples(const SampleCell& cell,
                  const CellSquare& square,
                  const Shape& shape) {
  const int log2 = square.size_log2;
  const std::array<double, 9> nine = nine_of(square, shape);
  const SampleCell expected = quantise(nine, log2);
  const double centre = std::round(nine[4] * 64) / 64;
  int wrong = 0;
  for (size_t byte = 0; byte < cell.size(); ++byte) {
    if (cell[byte] == expected[byte]) {
      continue;
    }
    const bool is_offset = byte >= format::samples::kOffsets;
    const size_t k = byte - format::samples::kOffsets;
    const double offset =
        is_offset ? std::ldexp(nine[k < 4 ? k : k + 1] - centre, 7 - log2) : 0;
    const double to_tie = std::fabs(offset - std::floor(offset) - 0.5);
    wrong += to_tie < 1e-9 ? 0 : 1;
  }
  return wrong;
}

// Cells that are sampled anew have the bytes of those that were moved, and
// saturated ones are on the same side.
TEST(Symmetry, CellsAreThoseOfTheMappedOutline) {
  size_t cells = 0;
  size_t same = 0;
  size_t saturated = 0;
  for (const Outline& outline : shapes()) {
    for (const Target& target : {targets()[1], targets()[2]}) {
      const SampleTree tree = build_sample_tree(Shape(outline), target);
      for (const Symmetry& symmetry : kAll) {
        const Shape other(mapped(outline, symmetry));
        const SampleTree moved = permuted(tree, symmetry, 0, 0);
        EXPECT_EQ(moved.cells.size(), tree.cells.size());
        for (const Leaf& leaf : leaves_of(moved)) {
          if (leaf.reference < format::glyph::kFirstNode) {
            const double middle = leaf.square.size_u() / 2.0;
            EXPECT_EQ(leaf.reference == format::glyph::kInside,
                      other.inside(leaf.square.x_u + middle,
                                   leaf.square.y_u + middle));
            ++saturated;
            continue;
          }
          const SampleCell& cell =
              moved.cells[leaf.reference ^ format::glyph::kCellFlag];
          ASSERT_EQ(wrong_samples(cell, leaf.square, other), 0)
              << leaf.square.x_u << ' ' << leaf.square.y_u;
          same += cell == quantise(nine_of(leaf.square, other),
                                   leaf.square.size_log2)
                      ? 1u
                      : 0u;
          ++cells;
        }
      }
    }
  }
  std::printf("%zu of %zu cells are the same bytes\n", same, cells);
  EXPECT_GT(cells, 10000u);
  EXPECT_GT(same, cells - cells / 1000);
  EXPECT_GT(saturated, 500u);
}

// The whole record, tiles, nodes and cells, where the grid of the mapped
// outline is the mapped grid: an even slack around a box of whole units.
TEST(Symmetry, RecordsAreThoseOfTheMappedOutline) {
  Outline outline;
  outline.contours = {rectangle(0, 0, 320, 40), rectangle(0, 0, 48, 576),
                      polygon({{100, 300}, {300, 420}, {170, 500}})};
  Target target;
  target.effort = 0;
  const SampleTree tree = build_sample_tree(Shape(outline), target);
  for (const Symmetry& symmetry : kAll) {
    const Shape other(mapped(outline, symmetry));
    EXPECT_EQ(field_record(permuted(tree, symmetry, 0, 0)),
              field_record(build_sample_tree(other, target)));
  }
}

TEST(Symmetry, FourQuarterTurnsAreTheSameBytes) {
  for (const Outline& outline : shapes()) {
    for (const Target& target : targets()) {
      const SampleTree tree = build_sample_tree(Shape(outline), target);
      const Bytes record = field_record(tree);
      SampleTree turned = tree;
      for (int quarter = 1; quarter <= 4; ++quarter) {
        turned = permuted(turned, kQuarter, 0, 0);
        EXPECT_EQ(field_record(turned) == record, quarter == 4);
      }
      for (const Symmetry& symmetry : {kAll[1], kAll[2], kAll[4], kAll[7]}) {
        const SampleTree once = permuted(tree, symmetry, 7, -30);
        const SampleTree back =
            permuted(permuted(once, kAll[0], -7, 30), symmetry, 0, 0);
        EXPECT_EQ(field_record(back), record);
      }
    }
  }
}

TEST(Symmetry, RefusesWhatLeavesTheGrid) {
  const SampleTree tree =
      build_sample_tree(Shape(load_outlines(kRoboto, 0, {'g'})[0]), Target());
  EXPECT_THROW(permuted(tree, kQuarter, 15300, 0), GeometryError);
  EXPECT_THROW(permuted(tree, kQuarter, 0, -15300), GeometryError);
}

}  // namespace
}  // namespace inkcell::gen::test
