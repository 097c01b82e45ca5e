// The area that a nib covers along a path, by brute force.
#pragma once

#include <vector>

#include "stroke/sweep.hpp"

namespace inkcell::design::test {

/// The exact distance of a point from the border of a nib at its place,
/// positive inside. [u]
double distance_to_nib(const NibPlace& place, const Point& point);

/// The area that a nib covers along the whole path.
class PathTruth {
 public:
  /// `path` must outlive this.
  explicit PathTruth(const NibPath& path);

  /// The maximum of distance_to_nib() over all places: 0 on the border of the
  /// covered area, exact outside, too small in magnitude inside. Samples 1/512
  /// of each piece, and refines the best.
  double distance(const Point& point) const;

 private:
  const NibPath& path_;
  std::vector<std::vector<NibPlace>> places_;  // of each piece
};

}  // namespace inkcell::design::test
