// Fitting second-order fields to exact distances.
#pragma once

#include <vector>

namespace inkcell {
namespace gen {

/// A distance to be met: at (x, y) from the anchor, within low..high. [u]
struct FitPoint {
  double x = 0;
  double y = 0;
  double d = 0;
  double low = 0;
  double high = 0;
};

/// d0 + n.q + k/2 (t.q)^2, n = (cos angle, sin angle).
struct PrimitiveFit {
  double d0 = 0;
  double angle = 0;  // [radian]
  double k = 0;
};

/// The field that comes nearest to `points`, in the sense of the largest
/// error in units of each point's leeway: Gauss-Newton with Lawson's weights.
/// False if there are too few points or they do not look like a field.
bool fit_field(const std::vector<FitPoint>& points,
               bool curved,
               PrimitiveFit& out);

/// The same with the angle given.
void fit_at_angle(const std::vector<FitPoint>& points,
                  bool curved,
                  PrimitiveFit& fit);

}  // namespace gen
}  // namespace inkcell
