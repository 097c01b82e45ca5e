// Points that a command names.
#pragma once

#include <set>
#include <utility>

#include "model/arguments.hpp"
#include "model/glyph.hpp"

namespace inkcell::design {

/// Contour and point, each pair once.
using PointSelection = std::set<std::pair<size_t, size_t>>;

/// The argument "points". Refuses points that the glyph does not have.
PointSelection parse_selection(const Glyph& glyph, const Arguments& arguments);

}  // namespace inkcell::design
