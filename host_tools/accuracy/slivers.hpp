// Which parts of a border are left over where contours cross by accident.
#pragma once

#include <cstdint>
#include <vector>

#include "truth.hpp"

namespace inkcell::tools {

/// A sliver has less area than this, and less mean width: that of a rectangle
/// as narrow as to have the same border. [u^2, u]
inline constexpr double kSliverArea = 4;
inline constexpr double kSliverWidth = 1.0 / 8;

/// How many slivers each piece is a border of: islands and holes, also those
/// that touch others at a point. 2 between an island and a hole. The area lies
/// to the left of each piece.
std::vector<uint8_t> find_slivers(const std::vector<TrueGlyph::Chord>& border);

}  // namespace inkcell::tools
