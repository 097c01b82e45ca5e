// A turn is measured between two chords of kArm_u along the contour, so that
// what is smaller than a pixel does not count.
#include "morph/morph_thorns.hpp"

#include <algorithm>
#include <cmath>

#include "shape/points.hpp"

namespace inkcell::gen {
namespace {

constexpr double kArm_u = 20;
constexpr double kLeastTurn = 30;  // [degrees]
constexpr double kLeastAround_u = 8 * kArm_u;

using Polygon = std::vector<Point>;
using Turns = std::vector<double>;  // at each point, positive to the left

size_t after(const Polygon& polygon, size_t i, bool is_forth) {
  const size_t n = polygon.size();
  return is_forth ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n : i) - 1;
}

Point arm_end(const Polygon& polygon, size_t from, bool is_forth) {
  double left = kArm_u;
  for (size_t i = from;;) {
    const size_t next = after(polygon, i, is_forth);
    const Point d = polygon[next] - polygon[i];
    const double size = length(d);
    if (size >= left) {
      return polygon[i] + (left / size) * d;
    }
    left -= size;
    i = next;
  }
}

double around(const Polygon& polygon) {
  double sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    sum += length(polygon[after(polygon, i, true)] - polygon[i]);
  }
  return sum;
}

Turns turns_of(const Polygon& polygon) {
  Turns turns(polygon.size());
  if (around(polygon) < kLeastAround_u) {
    return turns;
  }
  for (size_t i = 0; i < turns.size(); ++i) {
    const Point in = polygon[i] - arm_end(polygon, i, false);
    const Point out = arm_end(polygon, i, true) - polygon[i];
    turns[i] = std::atan2(cross(in, out), dot(in, out)) / kDegree;
  }
  return turns;
}

// The greatest of `values` within an arm of a point.
double greatest_near(const Polygon& polygon,
                     const Turns& values,
                     size_t at,
                     double sign) {
  double most = sign * values[at];
  for (const bool is_forth : {false, true}) {
    double left = kArm_u;
    for (size_t i = at;;) {
      const size_t next = after(polygon, i, is_forth);
      left -= length(polygon[next] - polygon[i]);
      if (left < 0 || next == at) {
        break;
      }
      most = std::max(most, sign * values[next]);
      i = next;
    }
  }
  return most;
}

// The sum over all places where a contour turns most beyond its ends.
double excess_of(const Polygon& polygon,
                 const Turns& first,
                 const Turns& last) {
  const Turns turns = turns_of(polygon);
  double sum = 0;
  for (const double sign : {-1.0, 1.0}) {
    Turns excess(turns.size());
    for (size_t i = 0; i < turns.size(); ++i) {
      if (sign * turns[i] > kLeastTurn) {
        excess[i] =
            std::max(0.0, sign * turns[i] -
                              std::max(greatest_near(polygon, first, i, sign),
                                       greatest_near(polygon, last, i, sign)));
      }
    }
    for (size_t i = 0; i < turns.size(); ++i) {
      sum += greatest_near(polygon, excess, i, 1) == excess[i] ? excess[i] : 0;
    }
  }
  return sum;
}

}  // namespace

double thorns_of(const std::vector<MorphPolygons>& frames) {
  double sum = 0;
  for (size_t i = 0; i < frames.front().size(); ++i) {
    const Polygon& first = frames.front()[i];
    const Polygon& last = frames.back()[i];
    if (around(first) < kLeastAround_u || around(last) < kLeastAround_u) {
      continue;
    }
    const Turns ends[] = {turns_of(first), turns_of(last)};
    for (size_t k = 1; k + 1 < frames.size(); ++k) {
      sum += excess_of(frames[k][i], ends[0], ends[1]);
    }
  }
  return sum / static_cast<double>(frames.size() - 2);
}

double thorns_of(const MorphPair& pair) {
  constexpr int kChords = 5;
  std::vector<MorphPolygons> frames;
  for (int step = 0; step <= kMorphSteps; ++step) {
    frames.push_back(
        morph_polygons(pair, static_cast<double>(step) / kMorphSteps, kChords));
  }
  return thorns_of(frames);
}

}  // namespace inkcell::gen
