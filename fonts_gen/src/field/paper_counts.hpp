// What other quadtrees need for the same glyph: the paper's comparison.
#pragma once

#include <cstddef>

#include "field/sample_tree.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {

/// Leaves of a quadtree.
struct LeafCounts {
  size_t all = 0;
  /// Without the constant ones: those that are all inside or all outside.
  size_t varying = 0;
};

/// Where the fixed predicate looks; size_aware looks at the whole band always.
enum class Scope {
  edge,  // cells with an edge in them
  band,  // all cells within 96 u of an edge
};

/// Leaves of a bi-linear ADF (Frisken et al. 2000: four distances at the
/// corners) under the conditions of build_sample_tree with the same options,
/// but with distances in full precision, tested on the lattice alone.
LeafCounts count_cells_bilinear(const Shape& shape,
                                const Target& options,
                                Scope scope = Scope::edge);

/// The same with nine distances: the fair partner of the bi-linear count. What
/// quantisation costs is the difference to build_sample_tree.
LeafCounts count_cells_biquadratic(const Shape& shape,
                                   const Target& options,
                                   Scope scope = Scope::edge);

/// Leaves of a 3-colour quadtree (inside, outside, edge) whose edge cells are
/// all 1 / `resolution` em wide, in the paper's root cell. `resolution` is a
/// power of two. varying counts the edge cells.
LeafCounts count_cells_three_colour(const Shape& shape, int resolution = 512);

}  // namespace inkcell::gen
