// Trees of shapes, from which glyphs are made.
#pragma once

#include <vector>

#include "model/project.hpp"

namespace inkcell::design {

/// The contours of a tree, in font units, counter-clockwise around ink. A leaf
/// is a glyph, { "glyph": "o", "matrix": [...] }; a node combines two or more
/// parts, in order:
///
///   { "op": "union" | "intersection" | "difference" | "exclusion" | "blend",
///     "radius": 20, "parts": [...] }
///
/// Radius and matrix in font units. Points of parts that are mapped are
/// rounded; those that no operator cuts or blends keep their places. Throws
/// Error that names the wrong part of the tree, or gen::GeometryError.
std::vector<PointContour> contours_of_tree(const Project& project,
                                           size_t layer,
                                           const Value& tree);

/// Adds what follows from a change: a glyph that is made of a tree is made anew
/// if the tree or one of its parts has changed. Throws Error.
void follow_parts(const Project& project, Change& change);

}  // namespace inkcell::design
