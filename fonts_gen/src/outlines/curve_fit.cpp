#include "outlines/curve_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell::gen {
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

void set_chords(const Point* points, size_t count, ChordList& chords) {
  chords.resize(count - 1);
  for (size_t i = 0; i + 1 < count; ++i) {
    chords[i] = chord_between(points[i], points[i + 1]);
  }
}

Point on_quadratic(const Segment& q, double t) {
  return on_quadratic(q.p[0], q.p[1], q.p[2], t);
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
  static thread_local std::vector<Point> corners;
  static thread_local ChordList polygon;
  corners.assign(1, chain.from);
  for (size_t i = 0; i < chain.controls.size(); ++i) {
    const Segment q = chain.quadratic(i);
    for (int k = 1; k <= kSteps; ++k) {
      corners.push_back(on_quadratic(q, static_cast<double>(k) / kSteps));
    }
  }
  set_chords(corners.data(), corners.size(), polygon);
  double most = 0;
  size_t edge = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    double best = kInfinity;
    size_t nearest = edge;
    for (size_t k = edge; k < polygon.size(); ++k) {
      const double d = polygon[k].squared_distance(points[i]);
      if (d < best) {
        best = d;
        nearest = k;
      }
    }
    edge = nearest;
    const Point along = direction(polygon[edge].d);
    places[i].parameter =
        (static_cast<double>(edge) + polygon[edge].nearest(points[i])) / kSteps;
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

  // Adds (row . unknowns - value)^2 to the sum of squares; what is 0 between
  // `first` and `last` stays. solve() fills `a` below the diagonal.
  void add(const double* row,
           size_t first,
           size_t last,
           double value,
           double weight) {
    for (size_t r = first; r < last; ++r) {
      const double f = weight * row[r];
      for (size_t c = r; c < last; ++c) {
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
  size_t begin_of[kMostFitControls + 1];  // the first unknown from a control on
  Equations equations;
  for (size_t i = 0; i < n; ++i) {
    begin_of[i] = equations.count;
    x_of[i] = fixed.x[i] ? kMostUnknowns : equations.count++;
    y_of[i] = fixed.y[i] ? kMostUnknowns : equations.count++;
  }
  begin_of[n] = equations.count;
  double w[kMostFitControls + 2];
  for (size_t k = 0; k < points.size(); ++k) {
    weights_at(places[k].parameter, n, w);
    Point rest = points[k] - w[0] * chain.from - w[n + 1] * chain.to;
    for (size_t i = 0; i < n; ++i) {
      rest.x -= fixed.x[i] ? w[i + 1] * fixed.at[i].x : 0;
      rest.y -= fixed.y[i] ? w[i + 1] * fixed.at[i].y : 0;
    }
    const Point normal = places[k].normal;
    // A place depends on its own control and on those beside it.
    const size_t own =
        std::min(static_cast<size_t>(places[k].parameter), n - 1);
    const size_t first = own == 0 ? 0 : own - 1;
    const size_t last = std::min(own + 2, n);
    const auto add = [&](const Point& axis, double weight) {
      double row[kMostUnknowns];
      for (size_t i = first; i < last; ++i) {
        if (!fixed.x[i]) {
          row[x_of[i]] = axis.x * w[i + 1];
        }
        if (!fixed.y[i]) {
          row[y_of[i]] = axis.y * w[i + 1];
        }
      }
      equations.add(row, begin_of[first], begin_of[last], dot(axis, rest),
                    weight);
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

Deviation::Deviation(const SampleSpan& source, double bound)
    : source_(source), bound_(bound) {
  set_chords(source.first, source.count, source_chords_);
}

void Deviation::flatten(const Chain& chain) {
  points_.clear();
  points_.push_back(chain.from);
  for (size_t i = 0; i < chain.controls.size(); ++i) {
    const Segment q = chain.quadratic(i);
    const int chords = std::clamp(chord_count(q, bound_), 4, kMostChords);
    for (int k = 1; k <= chords; ++k) {
      points_.push_back(on_quadratic(q, static_cast<double>(k) / chords));
    }
  }
  if (chain.controls.empty()) {
    points_.push_back(chain.to);
  }
  set_chords(points_.data(), points_.size(), chords_);
}

// The farthest of `points` from the polygon, or one above `limit`. The nearest
// edge only moves forward, so that a point is not compared with another part of
// a curve that comes back.
Deviation::Stray Deviation::stray(const Point* points,
                                  size_t count,
                                  const ChordList& polygon,
                                  double limit) {
  Stray worst;
  size_t edge = 0;
  for (size_t i = 0; i < count; ++i) {
    double best = kInfinity;
    int farther = 0;
    for (size_t k = edge; k < polygon.size(); ++k) {
      const double d = polygon[k].squared_distance(points[i]);
      if (d < best) {
        best = d;
        edge = k;
        farther = 0;
      } else if (best <= limit && ++farther == kFarther) {
        break;
      }
    }
    if (best > worst.square) {
      worst = {best, i};
      if (best > limit) {
        break;
      }
    }
  }
  return worst;
}

double Deviation::nearest(const Point& p, const ChordList& polygon) {
  double best = kInfinity;
  for (const Chord& chord : polygon) {
    best = std::min(best, chord.squared_distance(p));
  }
  return best;
}

// No more than the deviation of the chain.
double Deviation::at_witness() const {
  if (witness_ == Witness::source) {
    return nearest(source_.first[witness_point_], chords_);
  }
  return witness_ == Witness::chain && witness_point_ < points_.size()
             ? nearest(points_[witness_point_], source_chords_)
             : 0;
}

double Deviation::of(const Chain& chain, double limit) {
  flatten(chain);
  const double there = std::sqrt(at_witness());
  if (there >= limit) {
    return there;
  }
  const double most = limit * limit;
  const Stray of_chain =
      stray(points_.data(), points_.size(), source_chords_, most);
  if (of_chain.square > most) {
    return std::sqrt(of_chain.square);
  }
  const Stray of_source = stray(source_.first, source_.count, chords_, most);
  const bool chain_is_worse = of_chain.square > of_source.square;
  const Stray& worst = chain_is_worse ? of_chain : of_source;
  const double deviation = std::sqrt(worst.square);
  if (deviation < limit) {
    witness_ = chain_is_worse ? Witness::chain : Witness::source;
    witness_point_ = worst.point;
  }
  return deviation;
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

}  // namespace inkcell::gen
