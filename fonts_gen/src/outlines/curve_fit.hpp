// Fits a line, or a chain of quadratics, to a stretch of samples.
#pragma once

#include <cstddef>
#include <vector>

#include "shape/outline.hpp"

namespace inkcell {
namespace gen {

/// A line from `from` to `to`, or one quadratic for each control point, with
/// implied points between them.
struct Chain {
  Point from;
  std::vector<Point> controls;
  Point to;

  /// The i-th quadratic.
  Segment quadratic(size_t i) const;
};

/// Consecutive samples of the source.
struct SampleSpan {
  const Point* first;
  size_t count;  // 2 or more
};

/// The larger of two distances: of the samples from the chain, and of the chain
/// from the samples' polygon, both in order along the curve. Curves become
/// chords within `bound`. Stops above `limit` and returns a value above it.
double deviation(const SampleSpan& source,
                 const Chain& chain,
                 double limit,
                 double bound);

/// Coordinates of controls that are not free.
struct FixedControls {
  explicit FixedControls(size_t controls)
      : x(controls, false), y(controls, false), at(controls) {}

  std::vector<bool> x;
  std::vector<bool> y;
  std::vector<Point> at;
};

/// Most controls of a chain that fit_controls() finds.
inline constexpr size_t kMostFitControls = 6;

/// Sets the controls of `chain` to minimise the largest distance from `source`,
/// in a few rounds. False if `limit` seems out of reach.
bool fit_controls(const SampleSpan& source,
                  const FixedControls& fixed,
                  double limit,
                  Chain& chain);

}  // namespace gen
}  // namespace inkcell
