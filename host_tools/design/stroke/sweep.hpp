// What a nib covers on its way.
#pragma once

#include <vector>

#include "shape/outline.hpp"
#include "stroke/nib.hpp"

namespace inkcell::design {

/// A nib somewhere on its path.
struct NibPlace {
  Point at;  // [u]
  Nib nib;
};

/// A path of cubics and lines with a nib at each joint; in between its size and
/// angle change evenly along each piece. All nibs are of one kind.
struct NibPath {
  std::vector<gen::Segment> pieces;
  std::vector<Nib> nibs;  // one more than pieces
};

/// How far the result may be from what the nib covers. [u]
inline constexpr double kSweepBound_u = 1.0 / 16;

/// The nib at the parameter `t`, 0..1, of a piece.
NibPlace place_on(const NibPath& path, size_t piece, double t);

/// Places along the path: between neighbours the path leaves the chord, and the
/// nib's turn its hull, by less than half of kSweepBound_u. At least one.
std::vector<NibPlace> places_on(const NibPath& path);

/// The area that the nibs cover, moved in straight lines from place to place:
/// the union of the hulls of neighbours, of a turning nib those of its parts,
/// in whole numbers of 1/65536 u, so that no cusp, loop or cap is a special
/// case. Closed polygons, outer ones counter-clockwise, holes clockwise. Throws
/// gen::GeometryError.
std::vector<std::vector<Point>> sweep(const std::vector<NibPlace>& places);

}  // namespace inkcell::design
