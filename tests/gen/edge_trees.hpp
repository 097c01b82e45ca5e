// Trees of fields made by hand, and what docs/FORMAT.md says they are worth.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "edges/tree.hpp"
#include "inkcell/field.hpp"

namespace inkcell {
namespace gen {
namespace test {

/// The distance that fields make together, in real numbers. [u]
struct PlainValue {
  double value = 0;
  bool rounded = false;  // it is the distance from a vertex, or nearly
  /// Rounded numbers may well decide otherwise: two values that compete are
  /// the same, or the angle is about the least one that is rounded.
  bool close_call = false;
};

PlainValue plain_value(Join join,
                       const std::vector<Primitive>& fields,
                       double x,
                       double y);

struct TreeOptions {
  int tiles_x = 1;
  int tiles_y = 1;
  int depth = 3;
  PrimitiveSteps steps;
  /// Fields stay where readers can compute them (docs/FORMAT.md).
  bool within_limits = true;
};

/// A tree that the format can hold. Fields, joins and the use of earlier fields
/// are random.
EdgeTree random_tree(std::mt19937& random, const TreeOptions& options);

/// The square at a point of the grid, and its value there.
const TreeNode& square_at(const EdgeTree& tree, int x_u, int y_u);
PlainValue value_at(const EdgeTree& tree, const TreeNode& leaf, int x, int y);

/// `locate` and `distance_at` of both say the same at every `step`-th point of
/// whole u.
bool same_pictures(const GlyphField& a, const GlyphField& b, int step);

/// Opens a record; an empty field if that fails.
GlyphField open_record(const std::vector<uint8_t>& bytes);

/// The distance at a point of whole u. [u]
double distance_u(const GlyphField& field, int x_u, int y_u);

}  // namespace test
}  // namespace gen
}  // namespace inkcell
