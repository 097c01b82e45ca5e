#include "shape/neighbourhood.hpp"

#include <algorithm>
#include <cmath>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

// Points of a row that are processed together.
constexpr size_t kChunk = 32;

// The rounding error of doubles at coordinates up to kCoordinateLimit. [u]
constexpr double kRounding_u = 1e-7;

double squared_to_square(const Square& square, double x, double y) {
  const double dx = std::max({square.x - x, x - square.x - square.size, 0.0});
  const double dy = std::max({square.y - y, y - square.y - square.size, 0.0});
  return dx * dx + dy * dy;
}

// Narrows [t0, t1] to where low <= a + t d <= high.
void clip(double a, double d, double low, double high, double& t0, double& t1) {
  if (d == 0) {
    if (a < low || a > high) {
      t1 = -1;
    }
    return;
  }
  const double at_low = (low - a) / d;
  const double at_high = (high - a) / d;
  t0 = std::max(t0, std::min(at_low, at_high));
  t1 = std::min(t1, std::max(at_low, at_high));
}

bool meets(const Square& square, double ax, double ay, double dx, double dy) {
  double t0 = 0;
  double t1 = 1;
  clip(ax, dx, square.x, square.x + square.size, t0, t1);
  clip(ay, dy, square.y, square.y + square.size, t0, t1);
  return t0 <= t1;
}

}  // namespace

double Neighbourhood::Line::squared_distance(double x, double y) const {
  const double px = x - ax;
  const double py = y - ay;
  double t = (px * dx + py * dy) * inverse;
  t = t < 0 ? 0 : t;
  t = t > 1 ? 1 : t;
  const double ex = px - t * dx;
  const double ey = py - t * dy;
  return ex * ex + ey * ey;
}

Neighbourhood::Neighbourhood(const Shape& shape, const Square& square) {
  Neighbourhood all;
  all.shape_ = &shape;
  all.lines_.reserve(shape.edges().size());
  for (const Edge& edge : shape.edges()) {
    const double dx = edge.b.x - edge.a.x;
    const double dy = edge.b.y - edge.a.y;
    all.lines_.push_back({edge.a.x, edge.a.y, dx, dy, 1 / (dx * dx + dy * dy)});
  }
  *this = all.part(square);
}

// r: half the diagonal, c: the centre, m: the distance from c to the nearest
// edge. No point of the square is farther than m + r from the border, and none
// is nearer to an edge at distance e from c than e - r. So an edge with e > m +
// 2 r is never the nearest.
Neighbourhood Neighbourhood::part(const Square& part) const {
  const double cx = part.x + part.size / 2;
  const double cy = part.y + part.size / 2;
  std::vector<double> squares(edge_count());
  double least = kInfinity;
  for (size_t i = 0; i < edge_count(); ++i) {
    squares[i] = lines_[i].squared_distance(cx, cy);
    least = std::min(least, squares[i]);
  }
  const double reach =
      std::sqrt(least) + part.size * std::sqrt(2.0) + kRounding_u;
  const auto matters = [&](double square) { return square <= reach * reach; };
  Neighbourhood result;
  result.shape_ = shape_;
  result.square_ = part;
  result.lines_.reserve(static_cast<size_t>(
      std::count_if(squares.begin(), squares.end(), matters)));
  for (size_t i = 0; i < edge_count(); ++i) {
    if (matters(squares[i])) {
      result.lines_.push_back(lines_[i]);
    }
  }
  return result;
}

double Neighbourhood::distance(double x, double y) const {
  double best = kInfinity;
  for (const Line& line : lines_) {
    best = std::min(best, line.squared_distance(x, y));
  }
  const double size = std::sqrt(best);
  return shape_->inside(x, y) ? size : -size;
}

// The inner loop runs over points and has no branch and no sum, so compilers
// can vectorise it.
void Neighbourhood::distances(
    double x, double y, double step, size_t count, double* out) const {
  std::vector<double> crossings;
  shape_->crossings(y, crossings);
  size_t passed = 0;
  for (size_t first = 0; first < count; first += kChunk) {
    const size_t n = std::min(kChunk, count - first);
    double px[kChunk];
    double best[kChunk];
    for (size_t i = 0; i < n; ++i) {
      px[i] = x + static_cast<double>(first + i) * step;
      best[i] = kInfinity;
    }
    for (const Line line : lines_) {
      for (size_t i = 0; i < n; ++i) {
        const double d2 = line.squared_distance(px[i], y);
        best[i] = d2 < best[i] ? d2 : best[i];
      }
    }
    for (size_t i = 0; i < n; ++i) {
      while (passed < crossings.size() && crossings[passed] <= px[i]) {
        ++passed;
      }
      const double size = std::sqrt(best[i]);
      out[first + i] = passed % 2 == 1 ? size : -size;
    }
  }
}

double Neighbourhood::clearance() const {
  double best = kInfinity;
  for (const Line& line : lines_) {
    if (meets(square_, line.ax, line.ay, line.dx, line.dy)) {
      return 0;
    }
    best = std::min(
        {best, squared_to_square(square_, line.ax, line.ay),
         squared_to_square(square_, line.ax + line.dx, line.ay + line.dy)});
    for (int corner = 0; corner < 4; ++corner) {
      best = std::min(best, line.squared_distance(
                                square_.x + (corner & 1) * square_.size,
                                square_.y + (corner >> 1) * square_.size));
    }
  }
  return std::sqrt(best);
}

}  // namespace inkcell::gen
