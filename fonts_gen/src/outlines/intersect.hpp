// Where two pieces of contours meet.
#pragma once

#include <vector>

#include "shape/outline.hpp"

namespace inkcell {
namespace gen {

/// A common point of two segments: its parameters on both.
struct Meeting {
  double t = 0;
  double u = 0;
};

/// Points closer than this are one point. [u]
inline constexpr double kSamePoint_u = 1e-4;

/// Adds the common points of `a` and `b`, both monotonic in x and in y, to
/// `meetings`; a point may be added more than once. Lines that run along each
/// other meet at their ends. False if there are too many: curves that run along
/// each other.
bool find_meetings(const Segment& a,
                   const Segment& b,
                   std::vector<Meeting>& meetings);

}  // namespace gen
}  // namespace inkcell
