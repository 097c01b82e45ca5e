// One line, or one chain of quadratics, for a stretch of samples.
#pragma once

#include <cstddef>
#include <vector>

#include "shape/outline.hpp"

namespace inkcell {
namespace gen {

/// A line from `from` to `to`, or as many quadratics as there are controls,
/// with implied points between them.
struct Chain {
  Point from;
  std::vector<Point> controls;
  Point to;

  /// The i-th quadratic.
  Segment quadratic(size_t i) const;
};

/// Samples that follow each other along the source.
struct SampleSpan {
  const Point* first;
  size_t count;  // 2 or more
};

/// The larger of the distances of the samples from the chain and of the chain
/// from the samples' polygon, both taken in order along the curve. Curves are
/// chords within `bound`. Stops above `limit`, with anything above it.
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

/// Sets the controls of `chain` so that the largest distance from `source` is
/// as small as a few rounds make it. False if it does not look as if it could
/// become `limit`.
bool fit_controls(const SampleSpan& source,
                  const FixedControls& fixed,
                  double limit,
                  Chain& chain);

}  // namespace gen
}  // namespace inkcell
