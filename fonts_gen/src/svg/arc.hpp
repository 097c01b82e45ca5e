// Arcs of circles as cubics.
#pragma once

#include <algorithm>
#include <cmath>

#include "shape/points.hpp"

namespace inkcell::gen {

/// The number of cubics for an arc of `angle` [radians, either sign]: each an
/// eighth of a turn or less.
inline int arc_pieces(double angle) {
  constexpr double kMostArc = kPi / 4 + 1e-9;
  return std::max(1, static_cast<int>(std::ceil(std::fabs(angle) / kMostArc)));
}

/// Length of the handles of one cubic of `angle`, for a radius of 1. [radians]
inline double arc_handle(double angle) {
  return 4.0 / 3 * std::tan(angle / 4);
}

}  // namespace inkcell::gen
