// How wrong a distance is: the error that the predicates limit.
#pragma once

#include <algorithm>
#include <cmath>

#include "target/target.hpp"

namespace inkcell::gen {

/// Distance beyond which a distance only has to stay saturated, and to which
/// the paper's root cell extends. [u] 0.75 px at 8 px/em.
inline constexpr double kFixedBand_u = 96;

/// Cells beyond this size are always divided: their offsets are too coarse.
inline constexpr int kLargestCellLog2 = 8;

/// A cell whose centre is farther from the edge than this many cell sizes has
/// no edge in it: half the diagonal, rounded up.
inline constexpr double kHalfDiagonal = 0.7072;

/// The error of an approximate distance against the true one.
class Metric {
 public:
  explicit Metric(const Target& options)
      : predicate_(options.predicate),
        band_u_(gen::band_u(options)),
        tolerance_(options.predicate == Predicate::fixed ? 1
                                                         : options.tolerance),
        sharpest_u_(512 / options.max_px) {}

  double band_u() const { return band_u_; }

  /// What the user asked for. [error()] The paper: 1/1024 em.
  double tolerance() const { return tolerance_; }

  /// What a cell may show on the test lattice. [error()] Some of the tolerance
  /// stays for what the lattice does not see: coverage is rounded to 1/255,
  /// distances in px to 1/1024, and a bend of the true distance between the
  /// points of the finest lattice may add 1.5/255 at the very worst.
  double limit() const {
    return predicate_ == Predicate::fixed
               ? tolerance_
               : std::max(tolerance_ - kMargin, tolerance_ / 2);
  }

  /// Cells of this size are kept whatever they show. The paper: 1/512 em.
  int smallest_log2() const { return predicate_ == Predicate::fixed ? 1 : 0; }

  /// Whether the predicate looks at a cell with `centre_u` at its centre. The
  /// paper's only looks where the edge is.
  bool tests_cell(double centre_u, int size_log2) const {
    return predicate_ == Predicate::size_aware ||
           std::fabs(centre_u) <= std::ldexp(kHalfDiagonal, size_log2);
  }

  /// Half the ramp of the `text` filter at the largest size. [u]
  double sharpest_u() const { return sharpest_u_; }

  /// size_aware: largest difference in rendered intensity at any size from
  /// min_px to max_px [1/255]. fixed: difference in distance [u].
  double error(double truth_u, double approximation_u) const {
    return predicate_ == Predicate::fixed
               ? distance_error(truth_u, approximation_u)
               : intensity_error(truth_u, approximation_u);
  }

  /// Error that a difference of 1 u makes at the distance `truth_u`, at most.
  double slope(double truth_u) const {
    return predicate_ == Predicate::fixed
               ? 1
               : 255 / (2 * std::max(std::fabs(truth_u), sharpest_u_));
  }

 private:
  double distance_error(double d, double a) const {
    const bool saturated =
        std::min(d, a) >= band_u_ || std::max(d, a) <= -band_u_;
    return saturated ? 0 : std::fabs(a - d);
  }

  // The `text` filter is linear over +-c, c = half a pixel in u, which shrinks
  // as the size grows. Two distances of the same sign, lo < hi in magnitude,
  // differ most at the size where c = hi: by (hi - lo) / (2 hi). If hi is
  // sharper than the largest size, c stays at `sharpest`; if hi is beyond the
  // band, it is saturated and only lo counts. Distances of opposite sign differ
  // most at the largest size.
  double intensity_error(double d, double a) const {
    const double lo = std::min(std::fabs(d), std::fabs(a));
    const double hi = std::max(std::fabs(d), std::fabs(a));
    if ((d > 0) != (a > 0)) {
      return 255 * (std::min(lo, sharpest_u_) + std::min(hi, sharpest_u_)) /
             (2 * sharpest_u_);
    }
    if (hi > band_u_) {
      return 255 * std::max(0.0, band_u_ - lo) / (2 * band_u_);
    }
    return 255 * (hi - lo) / (2 * std::max(hi, sharpest_u_));
  }

  static constexpr double kMargin = 1.5;

  Predicate predicate_;
  double band_u_;
  double tolerance_;
  double sharpest_u_;
};

}  // namespace inkcell::gen
