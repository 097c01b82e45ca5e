#include "hints/edges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace inkcell::gen {
namespace {

// The steepest slope of an edge's chords.
constexpr double kSteepest = 0.2;
constexpr double kSteepestSpine = 0.7;

constexpr double kLeastEdge = 30;     // [u]
constexpr double kLeastDotEdge = 18;  // [u]
constexpr double kLargestDot = 165;   // [u]
constexpr double kLeastSpine = 100;   // [u]

// The flattest part of a spine: chords that are steeper by at most this.
constexpr double kSpineBend = 0.05;

// Chords of a spine on both sides of its flattest one.
constexpr size_t kSpineEnd = 2;

// An edge is straight if a single chord, flatter than kFlat, is most of it.
constexpr double kFlat = 0.02;
constexpr double kFlatShare = 0.6;

// Parts of one edge differ by less. If one is straight and the other round, as
// with feet of stems beside bowls, by still less. [u]
constexpr double kSameEdge = 11;
constexpr double kSameMixedEdge = 4;

// A bend rises by at least this on both sides of its extreme. [u]
constexpr double kBend = 0.5;

// Consecutive points of a polyline whose chords run in one direction.
struct Run {
  std::vector<Point> points;
  bool is_forward = false;  // `along` rises
};

bool is_forward(const Point& a, const Point& b, Axis axis) {
  return along(b, axis) > along(a, axis);
}

bool is_near_axis(const Point& a, const Point& b, Axis axis, double steepest) {
  const double run = std::abs(along(b, axis) - along(a, axis));
  const double rise = std::abs(position(b, axis) - position(a, axis));
  return run > 0 && rise <= steepest * run;
}

std::vector<Run> find_runs(const std::vector<Point>& line,
                           Axis axis,
                           double steepest) {
  const size_t n = line.size();
  const auto at = [&](size_t i) -> const Point& { return line[i % n]; };
  const auto fits = [&](size_t i) {
    return is_near_axis(at(i), at(i + 1), axis, steepest);
  };
  const auto continues = [&](size_t i) {
    return fits(i) && fits(i - 1) &&
           is_forward(at(i), at(i + 1), axis) ==
               is_forward(at(i - 1), at(i), axis);
  };
  // Chords are counted from n on, so that each has a predecessor.
  size_t first = n;
  while (first < 2 * n && continues(first)) {
    ++first;
  }
  std::vector<Run> runs;
  if (first == 2 * n) {
    return runs;
  }
  for (size_t i = first; i < first + n; ++i) {
    if (!fits(i)) {
      continue;
    }
    if (i == first || !continues(i)) {
      runs.push_back({{at(i)}, is_forward(at(i), at(i + 1), axis)});
    }
    runs.back().points.push_back(at(i + 1));
  }
  return runs;
}

// A chord has the index of its first point.
double rise_of(const Run& run, size_t chord, Axis axis) {
  return std::abs(position(run.points[chord + 1], axis) -
                  position(run.points[chord], axis));
}

double length_of(const Run& run, size_t chord, Axis axis) {
  return std::abs(along(run.points[chord + 1], axis) -
                  along(run.points[chord], axis));
}

size_t flattest_chord(const Run& run, Axis axis) {
  size_t best = 0;
  double most = 0;
  for (size_t i = 0; i + 1 < run.points.size(); ++i) {
    const double merit =
        length_of(run, i, axis) / (rise_of(run, i, axis) + 0.5);
    if (merit > most) {
      most = merit;
      best = i;
    }
  }
  return best;
}

Interval extent(const Run& run, Axis axis) {
  const double a = along(run.points.front(), axis);
  const double b = along(run.points.back(), axis);
  return {std::min(a, b), std::max(a, b)};
}

Interval range(const Run& run, Axis axis) {
  Interval range = {position(run.points[0], axis),
                    position(run.points[0], axis)};
  for (const Point& point : run.points) {
    range.low = std::min(range.low, position(point, axis));
    range.high = std::max(range.high, position(point, axis));
  }
  return range;
}

// Whether the chord is most of the run.
bool is_line(const Run& run, size_t chord, Axis axis) {
  return length_of(run, chord, axis) > kFlatShare * extent(run, axis).length();
}

bool is_straight(const Run& run, size_t chord, Axis axis) {
  return is_line(run, chord, axis) &&
         rise_of(run, chord, axis) < kFlat * length_of(run, chord, axis);
}

// The rise from the end with the smaller `along` to the other, if the run is a
// line.
double lean_of(const Run& run, size_t chord, Axis axis) {
  if (!is_line(run, chord, axis)) {
    return 0;
  }
  const double rise =
      position(run.points[chord + 1], axis) - position(run.points[chord], axis);
  return run.is_forward ? rise : -rise;
}

double middle_of(const Run& run, size_t chord, Axis axis) {
  return (position(run.points[chord], axis) +
          position(run.points[chord + 1], axis)) /
         2;
}

// The circle of a dot has short edges.
bool is_dot(const std::vector<Point>& line) {
  const auto [left, right] = std::minmax_element(
      line.begin(), line.end(),
      [](const Point& a, const Point& b) { return a.x < b.x; });
  const auto [bottom, top] = std::minmax_element(
      line.begin(), line.end(),
      [](const Point& a, const Point& b) { return a.y < b.y; });
  return right->x - left->x <= kLargestDot && top->y - bottom->y <= kLargestDot;
}

// The position at which the run bends back.
std::optional<double> extreme_of(const Run& run, Axis axis) {
  const double first = position(run.points.front(), axis);
  const double last = position(run.points.back(), axis);
  const Interval whole = range(run, axis);
  if (std::min(first, last) > whole.low + kBend) {
    return whole.low;
  }
  if (std::max(first, last) < whole.high - kBend) {
    return whole.high;
  }
  return {};
}

double slope_of(const Run& run, size_t chord, Axis axis) {
  return rise_of(run, chord, axis) / length_of(run, chord, axis);
}

// The mean of the flattest part of the run.
double flat_mean(const Run& run, size_t flattest, Axis axis) {
  const double steepest = slope_of(run, flattest, axis) + kSpineBend;
  double sum = 0;
  double lengths = 0;
  for (size_t i = 0; i + 1 < run.points.size(); ++i) {
    if (slope_of(run, i, axis) <= steepest) {
      const double length = length_of(run, i, axis);
      sum += length * middle_of(run, i, axis);
      lengths += length;
    }
  }
  return sum / lengths;
}

// The filled side is on the left: above if the run goes right, at smaller x if
// it goes up.
bool has_ink_beyond(const Run& run, Axis axis) {
  return run.is_forward == (axis == Axis::y);
}

// The longest piece gives the position.
std::vector<StrokeEdge> joined(std::vector<StrokeEdge> pieces) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const StrokeEdge& a, const StrokeEdge& b) {
                     return a.position < b.position;
                   });
  std::vector<StrokeEdge> edges;
  std::vector<double> longest;
  for (StrokeEdge& piece : pieces) {
    const double length = piece.length();
    size_t i = 0;
    while (i < edges.size() &&
           (edges[i].ink_beyond != piece.ink_beyond ||
            std::abs(edges[i].position - piece.position) >=
                (edges[i].is_round == piece.is_round ? kSameEdge
                                                     : kSameMixedEdge))) {
      ++i;
    }
    if (i == edges.size()) {
      edges.push_back(std::move(piece));
      longest.push_back(length);
      continue;
    }
    if (length > longest[i]) {
      longest[i] = length;
      edges[i].position = piece.position;
      edges[i].is_round = piece.is_round;
      edges[i].lean = piece.lean;
    }
    edges[i].pieces.push_back(piece.pieces.front());
  }
  std::stable_sort(edges.begin(), edges.end(),
                   [](const StrokeEdge& a, const StrokeEdge& b) {
                     return a.position < b.position;
                   });
  return edges;
}

}  // namespace

std::vector<StrokeEdge> find_edges(const Border& border, Axis axis) {
  std::vector<StrokeEdge> pieces;
  for (const std::vector<Point>& line : border.lines()) {
    const double least = is_dot(line) ? kLeastDotEdge : kLeastEdge;
    for (const Run& run : find_runs(line, axis, kSteepest)) {
      const std::optional<double> extreme = extreme_of(run, axis);
      if (extent(run, axis).length() < least) {
        continue;
      }
      const size_t flattest = flattest_chord(run, axis);
      const bool straight = is_straight(run, flattest, axis);
      const double middle = middle_of(run, flattest, axis);
      pieces.push_back({straight ? middle : extreme.value_or(middle),
                        has_ink_beyond(run, axis),
                        !straight,
                        lean_of(run, flattest, axis),
                        {extent(run, axis)}});
    }
  }
  return joined(std::move(pieces));
}

std::vector<StrokeEdge> find_spine_edges(const Border& border, Axis axis) {
  std::vector<StrokeEdge> pieces;
  for (const std::vector<Point>& line : border.lines()) {
    for (const Run& run : find_runs(line, axis, kSteepestSpine)) {
      const size_t flattest = flattest_chord(run, axis);
      const size_t chords = run.points.size() - 1;
      const double rise = std::abs(position(run.points.front(), axis) -
                                   position(run.points.back(), axis));
      if (extent(run, axis).length() > kLeastSpine &&
          rise > range(run, axis).length() - kBend && flattest >= kSpineEnd &&
          flattest + kSpineEnd < chords) {
        pieces.push_back({flat_mean(run, flattest, axis),
                          has_ink_beyond(run, axis),
                          true,
                          0,
                          {extent(run, axis)}});
      }
    }
  }
  return joined(std::move(pieces));
}

}  // namespace inkcell::gen
