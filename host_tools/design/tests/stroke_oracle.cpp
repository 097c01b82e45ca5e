#include "stroke_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace inkcell::design::test {
namespace {

constexpr int kSteps = 512;
constexpr int kRefinements = 40;

// Samples this far below the highest are refined as well. [u]
constexpr double kPromising_u = 8;

double distance_to_rectangle(double a, double b, const Point& p) {
  const double x = std::fabs(p.x) - a;
  const double y = std::fabs(p.y) - b;
  return x <= 0 && y <= 0 ? -std::max(x, y)
                          : -std::hypot(std::max(x, 0.0), std::max(y, 0.0));
}

// The nearest point of an ellipse, a >= b, to (x, y) in the first quadrant:
// (a^2 x / (t + a^2), b^2 y / (t + b^2)) for the root t > -b^2 of F(t) = 1,
// found by bisection.
double distance_to_ellipse(double a, double b, const Point& p) {
  if (a < b) {
    return distance_to_ellipse(b, a, {p.y, p.x});
  }
  const double x = std::fabs(p.x);
  const double y = std::fabs(p.y);
  const bool is_inside = x * x / (a * a) + y * y / (b * b) < 1;
  double low = -b * b + b * y;
  double high = -b * b + std::hypot(a * x, b * y);
  for (int i = 0; i < 60 && high > low; ++i) {
    const double t = (low + high) / 2;
    const double u = t + a * a == 0 ? 0 : a * x / (t + a * a);
    const double v = t + b * b == 0 ? 0 : b * y / (t + b * b);
    (u * u + v * v > 1 ? low : high) = t;
  }
  const double t = (low + high) / 2;
  Point nearest = {t + a * a == 0 ? 0 : a * a * x / (t + a * a),
                   t + b * b == 0 ? b : b * b * y / (t + b * b)};
  if (y == 0 && x * a < a * a - b * b) {
    // On the axis between the centres of curvature the root is -b^2.
    const double cosine = x * a / (a * a - b * b);
    nearest = {a * cosine, b * std::sqrt(1 - cosine * cosine)};
  }
  const double d = length(nearest - Point{x, y});
  return is_inside ? d : -d;
}

// An upper bound of distance_to_nib(): the distance to the circle around the
// nib.
double bound_of_distance(const NibPlace& place, const Point& point) {
  return std::hypot(std::max(place.nib.width, kLeastNib_u),
                    std::max(place.nib.height, kLeastNib_u)) /
             2 -
         length(point - place.at);
}

// The maximum near a sample, by ternary search.
template <typename Value>
double top_near(const Value& value, int sample) {
  double low = std::max(0.0, (sample - 1.0) / kSteps);
  double high = std::min(1.0, (sample + 1.0) / kSteps);
  for (int i = 0; i < kRefinements; ++i) {
    const double a = low + (high - low) / 3;
    const double b = high - (high - low) / 3;
    if (value(a) < value(b)) {
      low = a;
    } else {
      high = b;
    }
  }
  return value((low + high) / 2);
}

}  // namespace

double distance_to_nib(const NibPlace& place, const Point& point) {
  const Point off = point - place.at;
  const double c = std::cos(place.nib.angle);
  const double s = std::sin(place.nib.angle);
  const Point turned = {c * off.x + s * off.y, c * off.y - s * off.x};
  const double a = std::max(place.nib.width, kLeastNib_u) / 2;
  const double b = std::max(place.nib.height, kLeastNib_u) / 2;
  return place.nib.kind == Nib::Kind::ellipse
             ? distance_to_ellipse(a, b, turned)
             : distance_to_rectangle(a, b, turned);
}

PathTruth::PathTruth(const NibPath& path) : path_(path) {
  for (size_t piece = 0; piece < path.pieces.size(); ++piece) {
    std::vector<NibPlace> places;
    for (int i = 0; i <= kSteps; ++i) {
      places.push_back(place_on(path, piece, static_cast<double>(i) / kSteps));
    }
    places_.push_back(std::move(places));
  }
}

// A place whose bound is far below the best cannot be the maximum.
double PathTruth::distance(const Point& point) const {
  double best = -HUGE_VAL;
  for (size_t piece = 0; piece < places_.size(); ++piece) {
    std::vector<double> samples;
    for (const NibPlace& place : places_[piece]) {
      samples.push_back(bound_of_distance(place, point));
    }
    const auto nearest = std::max_element(samples.begin(), samples.end());
    const size_t first = static_cast<size_t>(nearest - samples.begin());
    double most = distance_to_nib(places_[piece][first], point);
    for (size_t k = 0; k < samples.size(); ++k) {
      if (samples[k] > most - kPromising_u) {
        samples[k] = distance_to_nib(places_[piece][k], point);
        most = std::max(most, samples[k]);
      }
    }
    best = std::max(best, most);
    const auto value = [&](double t) {
      return distance_to_nib(place_on(path_, piece, t), point);
    };
    for (int i = 0; i <= kSteps; ++i) {
      const size_t k = static_cast<size_t>(i);
      const bool is_top = (i == 0 || samples[k - 1] <= samples[k]) &&
                          (i == kSteps || samples[k + 1] <= samples[k]);
      if (is_top && samples[k] > most - kPromising_u) {
        best = std::max(best, top_near(value, i));
      }
    }
  }
  return best;
}

}  // namespace inkcell::design::test
