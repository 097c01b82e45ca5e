#include "outlines/curve_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell {
namespace gen {
namespace {

constexpr int kMostChords = 64;
// Ends the search for a nearer edge: so many edges ahead are farther, and the
// point is already near enough.
constexpr int kFarther = 3;
// Samples for least squares, a control.
constexpr size_t kSamplesPerControl = 10;

// A round of least squares.
struct Round {
  double along;     // the weight of distances along the chain
  double hopeless;  // limits: a sample farther than this ends the search
  bool weigh;       // the next round weighs samples by their distance
};
constexpr Round kRounds[] = {
    {1, 200, false},   {1, 100, false}, {0.1, 50, false}, {0.02, 20, false},
    {0.02, 12, false}, {0.02, 8, true}, {0.02, 6, true},  {0.02, 5, true},
    {0.02, 4, true},   {0.02, 3, true}};
// Limits: no further round is needed.
constexpr double kGoodEnough = 0.4;

Point on_quadratic(const Segment& q, double t) {
  const double s = 1 - t;
  return {s * s * q.p[0].x + 2 * s * t * q.p[1].x + t * t * q.p[2].x,
          s * s * q.p[0].y + 2 * s * t * q.p[1].y + t * t * q.p[2].y};
}

void flatten_chain(const Chain& chain,
                   double bound,
                   std::vector<Point>& points) {
  points.clear();
  points.push_back(chain.from);
  for (size_t i = 0; i < chain.controls.size(); ++i) {
    const Segment q = chain.quadratic(i);
    const int chords = std::clamp(chord_count(q, bound), 4, kMostChords);
    for (int k = 1; k <= chords; ++k) {
      points.push_back(on_quadratic(q, static_cast<double>(k) / chords));
    }
  }
  if (chain.controls.empty()) {
    points.push_back(chain.to);
  }
}

// The largest squared distance of `points` from the polygon, or a value above
// `limit`. The nearest edge only moves forward, so that a point is not compared
// with another part of a curve that comes back.
double stray(const Point* points,
             size_t count,
             const Point* polygon,
             size_t corners,
             double limit) {
  double worst = 0;
  size_t edge = 0;
  for (size_t i = 0; i < count; ++i) {
    double best = std::numeric_limits<double>::infinity();
    int farther = 0;
    for (size_t k = edge; k + 1 < corners; ++k) {
      const double d =
          squared_distance_to_segment(points[i], polygon[k], polygon[k + 1]);
      if (d < best) {
        best = d;
        edge = k;
        farther = 0;
      } else if (best <= limit && ++farther == kFarther) {
        break;
      }
    }
    worst = std::max(worst, best);
    if (worst > limit) {
      break;
    }
  }
  return worst;
}

// Points at equal distances along the samples, without the ends.
std::vector<Point> spread(const SampleSpan& source, size_t count) {
  std::vector<double> along(source.count, 0);
  for (size_t i = 1; i < source.count; ++i) {
    along[i] = along[i - 1] + length(source.first[i] - source.first[i - 1]);
  }
  std::vector<Point> points;
  size_t i = 1;
  for (size_t k = 1; k <= count; ++k) {
    const double at =
        along.back() * static_cast<double>(k) / static_cast<double>(count + 1);
    while (i + 1 < source.count && along[i] < at) {
      ++i;
    }
    const double size = along[i] - along[i - 1];
    const double t = size > 0 ? (at - along[i - 1]) / size : 0;
    points.push_back((1 - t) * source.first[i - 1] + t * source.first[i]);
  }
  return points;
}

// A place on the chain: index of the quadratic + its parameter.
struct Place {
  double parameter = 0;
  Point normal{0, 1};  // of length 1
  double distance = 0;
  double weight = 1;
};

// Finds the nearest places to `points`, in order along the chain. Returns the
// largest distance.
double find_places(const std::vector<Point>& points,
                   const Chain& chain,
                   std::vector<Place>& places) {
  constexpr int kSteps = 8;
  static thread_local std::vector<Point> polygon;
  polygon.assign(1, chain.from);
  for (size_t i = 0; i < chain.controls.size(); ++i) {
    const Segment q = chain.quadratic(i);
    for (int k = 1; k <= kSteps; ++k) {
      polygon.push_back(on_quadratic(q, static_cast<double>(k) / kSteps));
    }
  }
  double most = 0;
  size_t edge = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    double best = std::numeric_limits<double>::infinity();
    size_t nearest = edge;
    for (size_t k = edge; k + 1 < polygon.size(); ++k) {
      const double d =
          squared_distance_to_segment(points[i], polygon[k], polygon[k + 1]);
      if (d < best) {
        best = d;
        nearest = k;
      }
    }
    edge = nearest;
    const Point d = polygon[edge + 1] - polygon[edge];
    const double size = dot(d, d);
    const double t =
        size > 0
            ? std::clamp(dot(points[i] - polygon[edge], d) / size, 0.0, 1.0)
            : 0;
    const Point along = direction(d);
    places[i].parameter = (static_cast<double>(edge) + t) / kSteps;
    places[i].normal = {-along.y, along.x};
    places[i].distance = std::sqrt(best);
    most = std::max(most, places[i].distance);
  }
  return most;
}

// Weights of from, controls..., to at a place on the chain.
void weights_at(double parameter, size_t controls, double* weights) {
  std::fill(weights, weights + controls + 2, 0.0);
  const size_t i = std::min(static_cast<size_t>(parameter), controls - 1);
  const double t = parameter - static_cast<double>(i);
  const double s = 1 - t;
  const auto add_joint = [&](size_t joint, double weight) {
    if (joint == 0 || joint == controls) {
      weights[joint == 0 ? 0 : controls + 1] += weight;
    } else {
      weights[joint] += weight / 2;
      weights[joint + 1] += weight / 2;
    }
  };
  add_joint(i, s * s);
  weights[i + 1] += 2 * s * t;
  add_joint(i + 1, t * t);
}

// Lawson's method: weights grow where the distance is large, which minimises
// the largest distance.
void weigh(double most, std::vector<Place>& places) {
  for (Place& place : places) {
    place.weight *= 0.2 + place.distance / most;
  }
}

constexpr size_t kMostUnknowns = 2 * kMostFitControls;

// The normal equations for the free coordinates of the controls.
struct Equations {
  size_t count = 0;
  double a[kMostUnknowns][kMostUnknowns + 1] = {};

  // Adds (row . unknowns - value)^2 to the sum of squares. solve() fills `a`
  // below the diagonal.
  void add(const double* row, double value, double weight) {
    for (size_t r = 0; r < count; ++r) {
      const double f = weight * row[r];
      for (size_t c = r; c < count; ++c) {
        a[r][c] += f * row[c];
      }
      a[r][count] += f * value;
    }
  }

  // Gaussian elimination with pivoting; the solution is a[...][count]. False if
  // there is none.
  bool solve() {
    for (size_t r = 1; r < count; ++r) {
      for (size_t c = 0; c < r; ++c) {
        a[r][c] = a[c][r];
      }
    }
    for (size_t c = 0; c < count; ++c) {
      size_t pivot = c;
      for (size_t r = c + 1; r < count; ++r) {
        if (std::fabs(a[r][c]) > std::fabs(a[pivot][c])) {
          pivot = r;
        }
      }
      if (std::fabs(a[pivot][c]) < 1e-9) {
        return false;
      }
      std::swap_ranges(a[c], a[c] + count + 1, a[pivot]);
      for (size_t r = 0; r < count; ++r) {
        if (r != c) {
          const double f = a[r][c] / a[c][c];
          for (size_t k = c; k <= count; ++k) {
            a[r][k] -= f * a[c][k];
          }
        }
      }
    }
    for (size_t c = 0; c < count; ++c) {
      a[c][count] /= a[c][c];
    }
    return true;
  }
};

// One round. Distances across the chain have weight 1, those along it `along`,
// because samples may slide along it.
bool solve_controls(const std::vector<Point>& points,
                    const std::vector<Place>& places,
                    const FixedControls& fixed,
                    double along,
                    Chain& chain) {
  const size_t n = chain.controls.size();
  size_t x_of[kMostFitControls];
  size_t y_of[kMostFitControls];
  Equations equations;
  for (size_t i = 0; i < n; ++i) {
    x_of[i] = fixed.x[i] ? kMostUnknowns : equations.count++;
    y_of[i] = fixed.y[i] ? kMostUnknowns : equations.count++;
  }
  double w[kMostFitControls + 2];
  for (size_t k = 0; k < points.size(); ++k) {
    weights_at(places[k].parameter, n, w);
    Point rest = points[k] - w[0] * chain.from - w[n + 1] * chain.to;
    for (size_t i = 0; i < n; ++i) {
      rest.x -= fixed.x[i] ? w[i + 1] * fixed.at[i].x : 0;
      rest.y -= fixed.y[i] ? w[i + 1] * fixed.at[i].y : 0;
    }
    const Point normal = places[k].normal;
    const auto add = [&](const Point& axis, double weight) {
      double row[kMostUnknowns] = {};
      for (size_t i = 0; i < n; ++i) {
        if (!fixed.x[i]) {
          row[x_of[i]] = axis.x * w[i + 1];
        }
        if (!fixed.y[i]) {
          row[y_of[i]] = axis.y * w[i + 1];
        }
      }
      equations.add(row, dot(axis, rest), weight);
    };
    add(normal, places[k].weight);
    add({-normal.y, normal.x}, along * places[k].weight);
  }
  if (!equations.solve()) {
    return false;
  }
  for (size_t i = 0; i < n; ++i) {
    const auto solution = [&](size_t unknown) {
      return equations.a[unknown][equations.count];
    };
    chain.controls[i] = {fixed.x[i] ? fixed.at[i].x : solution(x_of[i]),
                         fixed.y[i] ? fixed.at[i].y : solution(y_of[i])};
  }
  return true;
}

}  // namespace

Segment Chain::quadratic(size_t i) const {
  Segment segment;
  segment.kind = Segment::Kind::quadratic;
  segment.p[0] = i == 0 ? from : middle(controls[i - 1], controls[i]);
  segment.p[1] = controls[i];
  segment.p[2] =
      i + 1 == controls.size() ? to : middle(controls[i], controls[i + 1]);
  return segment;
}

double deviation(const SampleSpan& source,
                 const Chain& chain,
                 double limit,
                 double bound) {
  static thread_local std::vector<Point> polygon;
  flatten_chain(chain, bound, polygon);
  const double most = limit * limit;
  const double there =
      stray(polygon.data(), polygon.size(), source.first, source.count, most);
  if (there > most) {
    return std::sqrt(there);
  }
  return std::sqrt(std::max(
      there,
      stray(source.first, source.count, polygon.data(), polygon.size(), most)));
}

bool fit_controls(const SampleSpan& source,
                  const FixedControls& fixed,
                  double limit,
                  Chain& chain) {
  const size_t n = chain.controls.size();
  const std::vector<Point> points = spread(source, kSamplesPerControl * n);
  std::vector<Place> places(points.size());
  for (size_t k = 0; k < points.size(); ++k) {
    places[k].parameter = static_cast<double>((k + 1) * n) /
                          static_cast<double>(points.size() + 1);
  }
  for (int round = 0;; ++round) {
    if (!solve_controls(points, places, fixed, kRounds[round].along, chain)) {
      return false;
    }
    if (round + 1 == static_cast<int>(std::size(kRounds))) {
      return true;
    }
    const double most = find_places(points, chain, places);
    if (most > kRounds[round].hopeless * limit) {
      return false;
    }
    if (most < kGoodEnough * limit) {
      return true;
    }
    if (kRounds[round].weigh) {
      weigh(most, places);
    }
  }
}

}  // namespace gen
}  // namespace inkcell
