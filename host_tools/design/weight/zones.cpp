#include "weight/zones.hpp"

#include <algorithm>
#include <cmath>

namespace inkcell::design {
namespace {

using gen::Point;

constexpr double kFlat_u = 0.02;    // of points of a level edge
constexpr double kShortest_u = 12;  // of an edge that is no extreme
constexpr double kMostBar_u = 300;  // of a bar or a stem
constexpr double kMatch_u = 6;      // of an edge and the ink behind it
constexpr double kHeight_u = 28;    // of overshoots
constexpr double kLeastRoom = 0.1;  // that a counter keeps
constexpr size_t kRows = 40;
constexpr size_t kFewRows = 4;  // that say nothing
// Of a counter between slanted stems, at least: its part of the height, and the
// slant of its sides.
constexpr double kCounterPart = 0.33;
constexpr double kSlant = 0.1;

// The loops of a shape's border.
std::vector<std::vector<Point>> loops_of(const gen::Shape& shape) {
  std::vector<std::vector<Point>> loops;
  const Point* end = nullptr;
  for (const gen::Edge& edge : shape.edges()) {
    if (end == nullptr || !(*end == edge.a)) {
      loops.emplace_back();
    }
    loops.back().push_back(edge.a);
    end = &edge.b;
  }
  return loops;
}

void add_edges(const std::vector<Point>& loop, std::vector<LevelEdge>& edges) {
  const size_t count = loop.size();
  const auto at = [&](size_t i) { return loop[i % count]; };
  const auto is_flat = [&](size_t i) {
    return std::abs(at(i + 1).y - at(i).y) <= kFlat_u;
  };
  size_t first = 0;
  while (first < count && is_flat(first)) {
    ++first;
  }
  for (size_t i = first + 1; i <= first + count;) {
    size_t last = i;  // the run of points with one y
    while (is_flat(last) && last < i + count) {
      ++last;
    }
    const double in = at(i).y - at(i - 1 + count).y;
    const double out = at(last + 1).y - at(last).y;
    const bool is_extreme = in * out < 0;
    const double run = std::abs(at(last).x - at(i).x);
    if (is_extreme || run >= kShortest_u) {
      const double way = last > i ? at(last).x - at(i).x
                                  : at(last + 1).x - at(i - 1 + count).x;
      edges.push_back(
          {at(i).y, (at(i).x + at(last).x) / 2, run / 2, way < 0, 0});
    }
    i = last + 1;
  }
}

// Of the ink behind an edge, along the other axis, at a part of its half.
double thickness_at(const LevelEdge& edge,
                    double part,
                    const gen::Shape& swapped) {
  std::vector<double> ends;
  swapped.crossings(edge.middle + part * edge.half, ends);
  for (size_t i = 0; i + 1 < ends.size(); i += 2) {
    const double near = edge.is_top ? ends[i + 1] : ends[i];
    if (std::abs(near - edge.place) < kMatch_u) {
      return ends[i + 1] - ends[i];
    }
  }
  return 0;
}

double place_of_row(const gen::Box& box, size_t row) {
  return box.y0 + (static_cast<double>(row) + 0.5) / kRows * (box.y1 - box.y0);
}

using Row = std::vector<double>;  // the ends of its runs of ink

// Adds the counter right of `end` in a row, if it is between slanted stems.
void add_counter(const gen::Box& box,
                 const std::vector<Row>& rows,
                 size_t row,
                 size_t end,
                 std::vector<SlantedCounter>& counters) {
  using Place = std::pair<size_t, size_t>;  // a row, and a number in it
  // The ends of ink left of the counter and right of it, from left to right.
  const auto at = [&rows](const Place& place, size_t i) {
    return rows[place.first][place.second - 1 + i];
  };
  std::vector<Place> places = {{row, end}};
  for (const size_t step : {size_t{1}, ~size_t{0}}) {  // upwards, downwards
    Place last = places.front();
    Place next = {row + step, 1};
    while (next.first < kRows && next.second + 1 < rows[next.first].size()) {
      if (at(last, 0) < at(next, 1) && at(next, 1) < at(last, 2) &&
          at(last, 1) < at(next, 2) && at(next, 2) < at(last, 3)) {
        places.push_back(next);
        last = next;
        next = {next.first + step, 1};
      } else {
        next.second += 2;
      }
    }
  }
  std::sort(places.begin(), places.end());
  const Place& low = places.front();
  const Place& high = places.back();
  const Place& middle = places[places.size() / 2];
  const double left = at(high, 1) - at(low, 1);
  const double right = at(high, 2) - at(low, 2);
  const double height =
      place_of_row(box, high.first) - place_of_row(box, low.first);
  if (height > kCounterPart * (box.y1 - box.y0) && left * right < 0 &&
      std::min(std::abs(left), std::abs(right)) > kSlant * height) {
    counters.push_back({(at(middle, 1) + at(middle, 2)) / 2,
                        place_of_row(box, middle.first),
                        at(middle, 2) - at(middle, 1)});
  }
}

bool is_height(double place, const std::vector<double>& heights) {
  return std::any_of(heights.begin(), heights.end(), [place](double height) {
    return std::abs(place - height) <= kHeight_u;
  });
}

}  // namespace

void Shift::add(double place, double by) {
  const auto next = std::lower_bound(
      knots_.begin(), knots_.end(), place,
      [](const Knot& knot, double value) { return knot.place < value; });
  const auto fits = [](const Knot& low, const Knot& high) {
    const double room = high.place - low.place;
    return low.by == high.by ||
           room + high.by - low.by >= std::max(kLeastRoom * room, 1.0);
  };
  const Knot knot = {place, by};
  if ((next == knots_.begin() || fits(*(next - 1), knot)) &&
      (next == knots_.end() || fits(knot, *next))) {
    knots_.insert(next, knot);
  }
}

double Shift::at(double place) const {
  if (knots_.empty()) {
    return 0;
  }
  const auto next = std::upper_bound(
      knots_.begin(), knots_.end(), place,
      [](double value, const Knot& knot) { return value < knot.place; });
  if (next == knots_.begin()) {
    return next->by;
  }
  const Knot& low = *(next - 1);
  if (next == knots_.end()) {
    return low.by;
  }
  return low.by +
         (place - low.place) / (next->place - low.place) * (next->by - low.by);
}

void Shift::raise(double place, double by, bool is_upwards) {
  for (Knot& knot : knots_) {
    if (is_upwards ? knot.place >= place : knot.place <= place) {
      knot.by += by;
    }
  }
}

std::vector<LevelEdge> level_edges(const gen::Shape& shape,
                                   const gen::Shape& swapped) {
  std::vector<LevelEdge> edges;
  for (const std::vector<Point>& loop : loops_of(shape)) {
    add_edges(loop, edges);
  }
  for (LevelEdge& edge : edges) {
    // A bar may meet a stem in its middle.
    for (const double part : {0.0, -0.7, 0.7}) {
      const double thickness = thickness_at(edge, part, swapped);
      if (thickness < kMostBar_u &&
          (edge.thickness == 0 || thickness < edge.thickness)) {
        edge.thickness = thickness;
      }
    }
  }
  return edges;
}

std::vector<Bar> bars_of(const std::vector<LevelEdge>& edges) {
  std::vector<Bar> found;
  for (const LevelEdge& top : edges) {
    if (!top.is_top || top.thickness == 0) {
      continue;
    }
    const double low = top.place - top.thickness;
    for (const LevelEdge& bottom : edges) {
      if (!bottom.is_top && std::abs(bottom.place - low) < kMatch_u) {
        found.push_back({bottom.place, top.place});
        break;
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const Bar& a, const Bar& b) {
    return a.high - a.low < b.high - b.low ||
           (a.high - a.low == b.high - b.low && a.low < b.low);
  });
  std::vector<Bar> bars;
  for (const Bar& bar : found) {
    if (std::none_of(bars.begin(), bars.end(), [&bar](const Bar& other) {
          return bar.low < other.high && other.low < bar.high;
        })) {
      bars.push_back(bar);
    }
  }
  return bars;
}

gen::Outline swapped(const gen::Outline& outline) {
  gen::Outline result = outline;
  for (gen::Contour& contour : result.contours) {
    for (gen::Segment& segment : contour.segments) {
      for (Point& p : segment.p) {
        std::swap(p.x, p.y);
      }
    }
  }
  return result;
}

Shift shift_of_heights(const std::vector<LevelEdge>& edges,
                       const gen::Box& box,
                       const Heights& heights,
                       double up) {
  Shift shift;
  const std::vector<Bar> bars = bars_of(edges);
  const auto holds = [&](double place, bool is_top) {
    return std::abs(place - (is_top ? box.y1 : box.y0)) < 0.5 ||
           is_height(place, is_top ? heights.tops : heights.bottoms);
  };
  const auto add_bar = [&shift](const Bar& bar, double by) {
    shift.add(bar.low, by);
    shift.add(bar.high, by);
  };
  std::vector<Bar> free;
  for (const Bar& bar : bars) {
    const bool low = holds(bar.low, false);
    const bool high = holds(bar.high, true);
    if (low && high) {  // a stop stands on the baseline, a dash floats
      add_bar(bar, is_height(bar.low, heights.bottoms) ? up
                   : is_height(bar.high, heights.tops) ? -up
                                                       : 0);
    } else if (low || high) {
      add_bar(bar, low ? up : -up);
    } else {
      free.push_back(bar);
    }
  }
  for (const LevelEdge& edge : edges) {
    const bool is_free =
        std::none_of(bars.begin(), bars.end(), [&edge](const Bar& bar) {
          return edge.place >= bar.low && edge.place <= bar.high;
        });
    if (is_free && holds(edge.place, edge.is_top)) {
      shift.add(edge.place, edge.is_top ? -up : up);
    }
  }
  for (const Bar& bar : free) {
    add_bar(bar, shift.at((bar.low + bar.high) / 2));
  }
  return shift;
}

StemShift shift_of_stems(const gen::Shape& shape,
                         const std::vector<LevelEdge>& edges,
                         double across,
                         double squeeze) {
  const gen::Box& box = shape.box();
  std::vector<Row> rows;
  size_t best = 0;
  for (size_t i = 0; i < kRows; ++i) {
    rows.emplace_back();
    shape.crossings(place_of_row(box, i), rows.back());
    const auto size = [&rows](size_t k) {
      const auto& row = rows[k];
      return std::pair(row.size(), row.empty() ? 0 : row.back() - row[0]);
    };
    best = size(rows.size() - 1) > size(best) ? rows.size() - 1 : best;
  }
  // How many runs of ink are before a place, at most, in several rows: a notch
  // where an arch leaves its stem is no counter.
  const auto rank_of = [&rows](double place) {
    std::vector<size_t> ranks;
    for (const Row& row : rows) {
      for (size_t i = 0; i + 1 < row.size(); i += 2) {
        if (place >= row[i] && place <= row[i + 1]) {
          ranks.push_back(i / 2);
        }
      }
    }
    std::sort(ranks.rbegin(), ranks.rend());
    return ranks.empty() ? 0.0
                         : static_cast<double>(
                               ranks[std::min(kFewRows, ranks.size() - 1)]);
  };
  std::vector<Bar> stems = bars_of(edges);
  for (size_t i = 0; i + 1 < rows[best].size(); i += 2) {
    const Bar run = {rows[best][i], rows[best][i + 1]};
    if (run.high - run.low < kMostBar_u &&
        std::none_of(stems.begin(), stems.end(), [&run](const Bar& stem) {
          return run.low < stem.high && stem.low < run.high;
        })) {
      const double middle = (run.low + run.high) / 2;
      stems.push_back({middle, middle});
    }
  }
  const double runs = std::max(1.0, static_cast<double>(rows[best].size()) / 2);
  StemShift result;
  Shift& shift = result.shift;
  // With all that the counters give, both ends hold and stems are between.
  const auto by_of = [&](double rank) {
    const double kept = across * (1 + 2 * rank);
    const double given =
        runs > 1 ? across * (1 - 2 * rank / (runs - 1)) : across;
    return kept + squeeze * (given - kept);
  };
  for (const Bar& stem : stems) {
    const double by = by_of(rank_of((stem.low + stem.high) / 2));
    shift.add(stem.low, by);
    if (stem.high > stem.low) {
      shift.add(stem.high, by);
    }
  }
  if (shift.empty()) {
    shift.add(0, across);
  }
  for (size_t end = 1; end + 1 < rows[best].size(); end += 2) {
    add_counter(box, rows, best, end, result.counters);
  }
  return result;
}

}  // namespace inkcell::design
