#include "fit/curve_fitter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/cubic_fit.hpp"
#include "fit/knots.hpp"

namespace inkcell::design {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The cost of a piece: a line costs less than a curve, errors a fraction.
constexpr double kLineCost = 0.75;
constexpr double kCurveCost = 1;
constexpr double kErrorCost = 0.3;

// Consecutive failures before longer pieces are not tried. Pieces that would
// not help do not count.
constexpr int kMostFailures = 8;

// A line may meet a smooth knot at this angle. [radians]
constexpr double kMostKink = 0.01;

// A curve that misses the tolerance is halved up to this often, down to this
// many points.
constexpr int kMostDivisions = 3;
constexpr size_t kLeastDivided = 12;

// Points on a curve at which the distance is looked up.
constexpr int kLooks = 16;

// One piece between two knots.
struct Candidate {
  gen::Segment segment;
  double cost = kInfinity;
};

class PieceFitter {
 public:
  PieceFitter(SmoothPiece piece, const FitOptions& options)
      : piece_(std::move(piece)),
        options_(options),
        lengths_(arc_lengths(piece_.points)) {
    KnotOptions knot_options;
    knot_options.tolerance = options.tolerance;
    knot_options.extremes = options.extremes;
    knots_ = find_knots(piece_, knot_options);
    if (piece_.is_closed) {
      // Both ends are the same place.
      knots_.back().tangent = knots_.front().tangent;
    }
  }

  std::vector<gen::Segment> run() {
    search();
    return refit(chosen_knots());
  }

 private:
  bool is_end(size_t k) const { return k == 0 || k + 1 == knots_.size(); }
  // Directions at the ends of an open piece are free: they are corners.
  std::optional<Point> tangent(size_t k) const {
    return is_end(k) && !piece_.is_closed
               ? std::nullopt
               : std::optional<Point>(knots_[k].tangent);
  }

  Stretch stretch(size_t i, size_t j) const {
    Stretch s;
    s.points = piece_.points.data() + knots_[i].at;
    s.lengths = lengths_.data() + knots_[i].at;
    s.count = knots_[j].at - knots_[i].at + 1;
    s.begin = tangent(i);
    s.end = tangent(j);
    return s;
  }

  // Stops at the first point beyond the tolerance.
  double line_error(const Stretch& s) const {
    double worst = 0;
    for (size_t i = 1; i + 1 < s.count && worst <= options_.tolerance; ++i) {
      worst = std::max(worst, distance_to_piece(s.points[i], s.points[0],
                                                s.points[s.count - 1]));
    }
    return worst;
  }

  double cost_of(double error, double base) const {
    const double share = error / options_.tolerance;
    return share > 1 ? kInfinity : base + kErrorCost * share * share;
  }

  Candidate line(const Stretch& s) const {
    Candidate result;
    const Point direction = unit(s.points[s.count - 1] - s.points[0]);
    for (const std::optional<Point>& t : {s.begin, s.end}) {
      if (t && std::fabs(turn(*t, direction)) > kMostKink) {
        return result;
      }
    }
    result.segment.kind = gen::Segment::Kind::line;
    result.segment.p[0] = s.points[0];
    result.segment.p[1] = s.points[s.count - 1];
    result.cost = cost_of(line_error(s), kLineCost);
    return result;
  }

  Candidate curve(const Stretch& s) const {
    const FittedCubic fitted = fit_cubic(s, options_.tolerance);
    double error = fitted.worst;
    if (error <= options_.tolerance && options_.distance) {
      for (int i = 1; i < kLooks; ++i) {
        const Point p =
            cubic_at(fitted.segment, static_cast<double>(i) / kLooks);
        error = std::max(error, std::fabs(options_.distance(p)));
      }
    }
    return {fitted.segment, cost_of(error, kCurveCost)};
  }

  // The cost of a piece from knot i to knot j if it makes the path to j
  // cheaper; nothing if even the best piece cannot.
  std::optional<double> useful_cost(size_t i, size_t j) const {
    const double room = best_[j] - best_[i];
    if (kLineCost >= room) {
      return std::nullopt;
    }
    const Stretch s = stretch(i, j);
    const double straight = line(s).cost;
    if (straight < kInfinity) {
      return straight;
    }
    return kCurveCost < room ? std::optional<double>(curve(s).cost)
                             : std::nullopt;
  }

  // Adjacent knots are always joined, beyond the tolerance if needed: by a
  // curve if its handles are sane.
  double last_resort(size_t i, size_t j) const {
    return j == i + 1 ? 10 : kInfinity;
  }

  void search() {
    const size_t count = knots_.size();
    best_.assign(count, kInfinity);
    from_.assign(count, 0);
    best_[0] = 0;
    for (size_t i = 0; i + 1 < count; ++i) {
      int failures = 0;
      for (size_t j = i + 1; j < count && failures < kMostFailures; ++j) {
        const std::optional<double> fitted = useful_cost(i, j);
        if (fitted) {
          failures = *fitted < kInfinity ? 0 : failures + 1;
        }
        const double cost =
            std::min(fitted.value_or(kInfinity), last_resort(i, j));
        if (best_[i] + cost < best_[j]) {
          best_[j] = best_[i] + cost;
          from_[j] = i;
        }
        if (knots_[j].is_forced) {
          break;
        }
      }
    }
  }

  std::vector<size_t> chosen_knots() const {
    std::vector<size_t> chosen;
    for (size_t k = knots_.size() - 1; k != 0; k = from_[k]) {
      chosen.push_back(k);
    }
    chosen.push_back(0);
    std::reverse(chosen.begin(), chosen.end());
    return chosen;
  }

  // Curves adopt the directions of adjacent lines, and are divided if they then
  // miss the tolerance.
  std::vector<gen::Segment> refit(const std::vector<size_t>& chosen) {
    std::vector<bool> is_line;
    for (size_t k = 0; k + 1 < chosen.size(); ++k) {
      is_line.push_back(line(stretch(chosen[k], chosen[k + 1])).cost <
                        kInfinity);
    }
    for (size_t k = 0; k < is_line.size(); ++k) {
      if (is_line[k]) {
        const Point direction = unit(piece_.points[knots_[chosen[k + 1]].at] -
                                     piece_.points[knots_[chosen[k]].at]);
        knots_[chosen[k]].tangent = direction;
        knots_[chosen[k + 1]].tangent = direction;
      }
    }
    std::vector<gen::Segment> segments;
    for (size_t k = 0; k < is_line.size(); ++k) {
      const Stretch s = stretch(chosen[k], chosen[k + 1]);
      if (is_line[k]) {
        gen::Segment segment;
        segment.p[0] = s.points[0];
        segment.p[1] = s.points[s.count - 1];
        segments.push_back(segment);
      } else {
        append_curves(s, kMostDivisions, segments);
      }
    }
    return segments;
  }

  void append_curves(const Stretch& s,
                     int divisions,
                     std::vector<gen::Segment>& segments) const {
    const Candidate whole = curve(s);
    if (whole.cost < kInfinity || divisions == 0 || s.count < kLeastDivided) {
      segments.push_back(whole.segment);
      return;
    }
    const size_t middle = s.count / 2;
    const size_t near = std::min<size_t>(middle, 5);
    Stretch first = s;
    first.count = middle + 1;
    first.end = unit(s.points[middle + near] - s.points[middle - near]);
    Stretch second = s;
    second.points += middle;
    second.lengths += middle;
    second.count -= middle;
    second.begin = first.end;
    append_curves(first, divisions - 1, segments);
    append_curves(second, divisions - 1, segments);
  }

  SmoothPiece piece_;
  const FitOptions& options_;
  std::vector<double> lengths_;  // to each point
  std::vector<Knot> knots_;
  std::vector<double> best_;  // cost up to each knot
  std::vector<size_t> from_;
};

SmoothPiece cut(const Loop& loop, size_t first, size_t count) {
  SmoothPiece piece;
  const size_t size = loop.points.size();
  for (size_t i = 0; i < count; ++i) {
    piece.points.push_back(loop.points[(first + i) % size]);
    piece.tangents.push_back(loop.tangents[(first + i) % size]);
  }
  // A corner has two directions.
  if (count > 2) {
    for (Point* tangent : {&piece.tangents.front(), &piece.tangents.back()}) {
      if (tangent->x == 0 && tangent->y == 0) {
        *tangent = tangent == &piece.tangents.front()
                       ? piece.tangents[1]
                       : piece.tangents[count - 2];
      }
    }
  }
  return piece;
}

}  // namespace

gen::Contour fit_loop(const Loop& loop, const FitOptions& options) {
  gen::Contour contour;
  const size_t size = loop.points.size();
  if (size < 3) {
    return contour;
  }
  const auto append = [&](SmoothPiece piece) {
    for (const gen::Segment& segment :
         PieceFitter(std::move(piece), options).run()) {
      contour.segments.push_back(segment);
    }
  };
  if (loop.corners.empty()) {
    size_t top = 0;
    for (size_t i = 1; i < size; ++i) {
      top = loop.points[i].y > loop.points[top].y ? i : top;
    }
    SmoothPiece piece = cut(loop, top, size + 1);
    piece.is_closed = true;
    append(std::move(piece));
    return contour;
  }
  for (size_t k = 0; k < loop.corners.size(); ++k) {
    const size_t first = loop.corners[k];
    const size_t next = loop.corners[(k + 1) % loop.corners.size()];
    append(cut(loop, first, (next + size - first - 1) % size + 2));
  }
  return contour;
}

gen::Outline fit_loops(const std::vector<Loop>& loops,
                       const FitOptions& options) {
  gen::Outline outline;
  for (const Loop& loop : loops) {
    gen::Contour contour = fit_loop(loop, options);
    if (!contour.segments.empty()) {
      outline.contours.push_back(std::move(contour));
    }
  }
  return outline;
}

std::vector<gen::Segment> fit_open(const std::vector<Point>& points,
                                   double tolerance,
                                   std::vector<size_t>& ends) {
  SmoothPiece piece;
  piece.points = points;
  const size_t last = points.size() - 1;
  for (size_t i = 0; i <= last; ++i) {
    piece.tangents.push_back(
        unit(points[std::min(i + 1, last)] - points[i == 0 ? 0 : i - 1]));
  }
  FitOptions options;
  options.tolerance = tolerance;
  options.extremes = false;
  std::vector<gen::Segment> segments = PieceFitter(piece, options).run();
  // Pieces begin and end at points.
  size_t at = 0;
  for (const gen::Segment& segment : segments) {
    const Point& end =
        segment.p[segment.kind == gen::Segment::Kind::line ? 1 : 3];
    while (at < last && !same(points[at], end)) {
      ++at;
    }
    ends.push_back(at);
  }
  return segments;
}

size_t segment_count(const gen::Outline& outline) {
  const auto end = [](const gen::Segment& s) {
    return s.kind == gen::Segment::Kind::line        ? s.p[1]
           : s.kind == gen::Segment::Kind::quadratic ? s.p[2]
                                                     : s.p[3];
  };
  size_t count = 0;
  for (const gen::Contour& contour : outline.contours) {
    for (const gen::Segment& segment : contour.segments) {
      const bool is_point = segment.kind == gen::Segment::Kind::line &&
                            same(segment.p[0], segment.p[1]);
      count += is_point ? 0 : 1;
    }
    if (!contour.segments.empty() &&
        !same(contour.segments.front().p[0], end(contour.segments.back()))) {
      ++count;
    }
  }
  return count;
}

}  // namespace inkcell::design
