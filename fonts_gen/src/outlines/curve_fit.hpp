// Fits a line, or a chain of quadratics, to a stretch of samples.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "shape/outline.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {

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

using ChordList = std::vector<Chord>;

/// The distances of chains from samples of the source.
class Deviation {
 public:
  /// Curves become chords within `bound`. Refers to the samples.
  Deviation(const SampleSpan& source, double bound);

  /// The larger of two distances: of the samples from the chain, and of the
  /// chain from the samples' polygon, both in order along the curve. If that is
  /// not below `limit`, stops early and returns any value that is not.
  ///
  /// Looks first where the last chain with a result below its limit was worst:
  /// quick for chains that are a little worse.
  double of(const Chain& chain, double limit);

 private:
  // A point, and its squared distance from a polygon.
  struct Stray {
    double square = 0;
    size_t point = 0;
  };
  static Stray stray(const Point* points,
                     size_t count,
                     const ChordList& polygon,
                     double limit);
  static double nearest(const Point& p, const ChordList& polygon);

  void flatten(const Chain& chain);
  double at_witness() const;

  SampleSpan source_;
  double bound_;
  ChordList source_chords_;
  std::vector<Point> points_;  // of the chain's chords
  ChordList chords_;
  // A point of the source, or of the chain.
  enum class Witness { none, source, chain } witness_ = Witness::none;
  size_t witness_point_ = 0;
};

/// Coordinates of controls that are not free.
struct FixedControls {
  explicit FixedControls(size_t controls)
      : x(controls, false), y(controls, false), at(controls) {}

  bool any() const {
    const auto any_of = [](const std::vector<bool>& fixed) {
      return std::find(fixed.begin(), fixed.end(), true) != fixed.end();
    };
    return any_of(x) || any_of(y);
  }

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

}  // namespace inkcell::gen
