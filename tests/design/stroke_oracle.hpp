// What a nib covers on its way, by trying all of the way.
#pragma once

#include "stroke/sweep.hpp"

namespace inkcell::design::test {

/// Distance of a point from the border of a nib at its place, positive inside.
/// [u] Exact.
double distance_to_nib(const NibPlace& place, const Point& point);

/// The greatest of these on the whole path: 0 on the border of what the nib
/// covers, exact outside, too small in magnitude inside. Found on 1/512 of each
/// piece, and finer around the best.
double distance_to_path(const NibPath& path, const Point& point);

}  // namespace inkcell::design::test
