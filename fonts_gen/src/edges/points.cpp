#include "edges/points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace inkcell {
namespace gen {
namespace {

constexpr float kAnything = std::numeric_limits<float>::infinity();

// Steps of the lattice across a cell, and across the largest ones.
constexpr int kSteps = 16;
constexpr int kStepsOfTile = 32;

// Cells with coarser lattices than this get one of half the step where the
// edge is near. [u]
constexpr int kFineStep_u = 4;

// Whatever the tolerance, a distance has the right sign a pixel from the edge.
constexpr double kMostSlack = 0.95;

// Extra points are where the device was found to miss: they keep this much of
// the tolerance for its rounding. [1/255]
constexpr double kRounding = 0.9;

}  // namespace

PointSource::PointSource(const Shape& shape,
                         const Metric& metric,
                         const Grid& grid,
                         double limit)
    : metric_(metric),
      grid_(grid),
      limit_(limit),
      truth_(shape,
             grid.x0_u,
             grid.y0_u,
             grid.tiles_x << grid.tile_log2,
             grid.tiles_y << grid.tile_log2) {}

// The inverse of Metric::error, which grows with the difference on both sides.
void PointSource::allow(float d, double limit, float& low, float& high) const {
  const double t = std::min(2 * limit / 255, kMostSlack);
  const double sharpest = metric_.sharpest_u();
  const double band = metric_.band_u();
  const double size = std::fabs(d);
  const double least =
      size <= band ? size - t * std::max(size, sharpest) : band * (1 - t);
  double most = kAnything;
  if (size < band * (1 - t)) {
    most =
        size + t * sharpest <= sharpest ? size + t * sharpest : size / (1 - t);
  }
  low = static_cast<float>(d >= 0 ? least : -most);
  high = static_cast<float>(d >= 0 ? most : -least);
}

// What an error of 1 u at a point for 1 u^2 adds to the sum of squares. A point
// at the distance d is on the ramp at all sizes below that at which it leaves
// it, and counts less the fewer these are: in the mean of all sizes the weight
// falls with the third power of the distance.
double PointSource::weight(float d) const {
  const double sharpest = metric_.sharpest_u();
  const double per_u = metric_.slope(static_cast<double>(d));
  const double sizes = sharpest / std::max<double>(std::fabs(d), sharpest);
  const double error = per_u / metric_.tolerance();
  return error * error * sizes / (4 * sharpest * sharpest);
}

// A point that stands for `area`. [u^2]
void PointSource::add(double x,
                      double y,
                      const TruthSample& sample,
                      double limit,
                      double area,
                      Points& points) const {
  float low = 0;
  float high = 0;
  allow(sample.distance_u, limit, low, high);
  const bool in_band = std::fabs(sample.distance_u) < metric_.band_u();
  points.x.push_back(static_cast<float>(x));
  points.y.push_back(static_cast<float>(y));
  points.d.push_back(sample.distance_u);
  points.low.push_back(low);
  points.high.push_back(high);
  const bool bounded = std::isfinite(low) && std::isfinite(high);
  points.weight.push_back(
      bounded ? static_cast<float>(area * weight(sample.distance_u)) : 0.0f);
  points.chain.push_back(sample.chain);
  points.corner.push_back(sample.corner);
  points.in_band.push_back(in_band);
  points.in_band_count += in_band ? 1 : 0;
  if (in_band && sample.corner >= 0 &&
      (points.corners.empty() || points.corners.back() != sample.corner)) {
    points.corners.push_back(sample.corner);
  }
}

// The odd points of a lattice of half the step, where the edge is nearer than
// that step. The coarse point beside says whether it is worth a look.
void PointSource::add_near_edge(
    int x_u, int y_u, int size, int step, Points& points) {
  const int fine = step / 2;
  for (int j = 0; j <= size; j += fine) {
    const bool odd_row = (j / fine) % 2 != 0;
    for (int i = odd_row ? 0 : fine; i <= size; i += odd_row ? fine : step) {
      const TruthSample& coarse =
          truth_.at(x_u + i / step * step, y_u + j / step * step);
      if (std::fabs(coarse.distance_u) >= static_cast<float>(2 * step)) {
        continue;
      }
      const TruthSample& sample = truth_.at(x_u + i, y_u + j);
      if (std::fabs(sample.distance_u) < static_cast<float>(step)) {
        add(x_u + i, y_u + j, sample, limit_, fine * fine, points);
      }
    }
  }
}

Points PointSource::collect(int x_u, int y_u, int size_log2) {
  Points points;
  const int size = 1 << size_log2;
  const int steps = size_log2 >= 8 ? kStepsOfTile : kSteps;
  const int step = std::max(1, size / steps);
  const bool refined = step >= kFineStep_u;
  const auto side = static_cast<size_t>(size / step + 1);
  points.reserve(side * side * (refined ? 2 : 1));
  for (int j = 0; j <= size; j += step) {
    for (int i = 0; i <= size; i += step) {
      const TruthSample& sample = truth_.at(x_u + i, y_u + j);
      const bool dense =
          refined && std::fabs(sample.distance_u) < static_cast<float>(step);
      add(x_u + i, y_u + j, sample, limit_, step * step / (dense ? 4 : 1),
          points);
    }
  }
  if (refined) {
    add_near_edge(x_u, y_u, size, step, points);
  }
  for (const Point& p : extra_) {
    if (p.x >= x_u && p.x <= x_u + size && p.y >= y_u && p.y <= y_u + size) {
      add(p.x, p.y, truth_.at_point(p.x, p.y), limit_ - kRounding, 0, points);
    }
  }
  std::sort(points.corners.begin(), points.corners.end());
  points.corners.erase(
      std::unique(points.corners.begin(), points.corners.end()),
      points.corners.end());
  return points;
}

bool PointSource::saturated(const Points& points, bool& inside) const {
  inside = points.d[0] > 0;
  const double band =
      metric_.band_u() * (1 - std::min(2 * limit_ / 255, kMostSlack));
  for (const float d : points.d) {
    if ((d > 0) != inside || std::fabs(d) < band) {
      return false;
    }
  }
  return true;
}

}  // namespace gen
}  // namespace inkcell
