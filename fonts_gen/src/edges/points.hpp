// Where a cell of primitives is tested, and what it may show there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shape/distance_lattice.hpp"
#include "target/grid.hpp"
#include "target/metric.hpp"

namespace inkcell {
namespace gen {

/// The points at which a cell is tested. At point i the distance is d[i]; a
/// field that says low[i]..high[i] there keeps the limit. [u]
struct Points {
  std::vector<float> x, y, d, low, high;
  /// What the square of an error counts, so that the sum over the points of a
  /// cell is one over its pixels at the largest size, of errors in tolerances.
  /// [1/u^2]
  std::vector<float> weight;
  /// What is nearest: DistanceLattice's numbers. corner -1: no corner.
  std::vector<int16_t> chain, corner;
  /// Corners that are nearest to some point in the band, ascending.
  std::vector<int16_t> corners;
  std::vector<bool> in_band;
  size_t in_band_count = 0;

  size_t size() const { return x.size(); }

  void reserve(size_t count) {
    for (std::vector<float>* each : {&x, &y, &d, &low, &high, &weight}) {
      each->reserve(count);
    }
    chain.reserve(count);
    corner.reserve(count);
    in_band.reserve(count);
  }

  bool keeps_limit(size_t i, float v) const {
    return v >= low[i] && v <= high[i];
  }
};

/// Knows the truth about one glyph, and where to look.
class PointSource {
 public:
  /// `limit`: of Metric::error [1/255]. `shape` must outlive it.
  PointSource(const Shape& shape,
              const Metric& metric,
              const Grid& grid,
              double limit);

  /// More points to test, wherever they lie. They are held to `limit`.
  void add_extra(const Point& point) { extra_.push_back(point); }

  /// A lattice over the cell (borders included), denser near the edge, and the
  /// extra points.
  Points collect(int x_u, int y_u, int size_log2);

  /// Whether nothing but saturation is wanted at all of `points`; `inside`
  /// says on which side.
  bool saturated(const Points& points, bool& inside) const;

  /// The distances that pass for `d`. [u]
  void allow(float d, float& low, float& high) const {
    allow(d, limit_, low, high);
  }

  DistanceLattice& truth() { return truth_; }
  const Metric& metric() const { return metric_; }
  const Grid& grid() const { return grid_; }

 private:
  void allow(float d, double limit, float& low, float& high) const;
  double weight(float d) const;
  void add(double x,
           double y,
           const TruthSample& sample,
           double limit,
           double area,
           Points& points) const;
  void add_near_edge(int x_u, int y_u, int size, int step, Points& points);

  Metric metric_;
  Grid grid_;
  double limit_;
  DistanceLattice truth_;
  std::vector<Point> extra_;
};

}  // namespace gen
}  // namespace inkcell
