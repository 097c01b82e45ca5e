// What a nib covers on its way, by trying all of the way.
#pragma once

#include <vector>

#include "stroke/sweep.hpp"

namespace inkcell::design::test {

/// Distance of a point from the border of a nib at its place, positive inside.
/// [u] Exact.
double distance_to_nib(const NibPlace& place, const Point& point);

/// What a nib covers on the whole path.
class PathTruth {
 public:
  /// `path` must outlive this.
  explicit PathTruth(const NibPath& path);

  /// The greatest distance_to_nib() of all places: 0 on the border of what the
  /// nib covers, exact outside, too small in magnitude inside. Found on 1/512
  /// of each piece, and finer around the best.
  double distance(const Point& point) const;

 private:
  const NibPath& path_;
  std::vector<std::vector<NibPlace>> places_;  // of each piece
};

}  // namespace inkcell::design::test
