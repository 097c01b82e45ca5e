// The area that a nib covers along a path.
#pragma once

#include <vector>

#include "shape/outline.hpp"
#include "stroke/nib.hpp"

namespace inkcell::design {

/// A nib at a point of its path.
struct NibPlace {
  Point at;  // [u]
  Nib nib;
};

/// A path of cubics and lines with a nib at each joint. Size and angle change
/// linearly along each piece. All nibs are of one kind.
struct NibPath {
  std::vector<gen::Segment> pieces;
  std::vector<Nib> nibs;  // one more than pieces
};

/// The largest error of the result. [u]
inline constexpr double kSweepBound_u = 1.0 / 16;

/// The nib at the parameter `t`, 0..1, of a piece.
NibPlace place_on(const NibPath& path, size_t piece, double t);

/// Points on the path so close that between neighbours the path leaves the
/// chord, and the turning nib its hull, by less than half of kSweepBound_u. At
/// least one.
std::vector<NibPlace> places_on(const NibPath& path);

/// The area that the nibs cover when moved in straight lines from place to
/// place: the union of the hulls of neighbours; a turning nib is divided first.
/// Coordinates are integers in 1/65536 u, so cusps, loops and caps need no
/// special case. Closed polygons, outer ones counter-clockwise, holes
/// clockwise. Throws gen::GeometryError.
std::vector<std::vector<Point>> sweep(const std::vector<NibPlace>& places);

}  // namespace inkcell::design
