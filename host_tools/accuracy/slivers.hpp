// Which parts of a border are left over where contours cross by accident.
#pragma once

#include <vector>

#include "truth.hpp"

namespace inkcell::tools {

/// A sliver has less area than this, and less mean width: that of a rectangle
/// as narrow as to have the same border. [u^2, u]
inline constexpr double kSliverArea = 4;
inline constexpr double kSliverWidth = 1.0 / 8;

/// Whether each piece is the border of a sliver: an island, or a hole, also one
/// that touches others at a point. The area lies to the left of each piece.
std::vector<bool> find_slivers(const std::vector<TrueGlyph::Chord>& border);

}  // namespace inkcell::tools
