#include "svg/circles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "shape/flatten.hpp"
#include "shape/points.hpp"
#include "svg/arc.hpp"

namespace inkcell::gen {
namespace {

constexpr double kTurn = 2 * kPi;
constexpr double kEighth = kTurn / 8;

double within_turn(double angle) {
  return angle - kTurn * std::floor(angle / kTurn);
}

bool is_eighth(double angle) {
  constexpr double kRounding = 1e-9;
  return std::fabs(std::remainder(angle, kEighth)) < kRounding;
}

// The place of the end that is nearest to `angle` in an ascending list of
// angles from 0 on.
size_t nearest(const std::vector<double>& ends, double angle) {
  const double at = within_turn(angle);
  const auto above = std::lower_bound(ends.begin(), ends.end(), at);
  const auto i = static_cast<size_t>(above - ends.begin());
  const double next = i == ends.size() ? kTurn : ends[i];
  return i > 0 && at - ends[i - 1] < next - at ? i - 1 : i % ends.size();
}

const Point& last_point(const Segment& segment) {
  return segment.p[static_cast<int>(segment.kind) + 1];
}

}  // namespace

// A border that ends on its circle d radians beside its place strays by radius
// d^2 / 2, as it is tangent there: ends that are one cost 1/32 of the bound.
Circles::Circles(const PenStyle& pen, double bound, double near)
    : pen_(pen),
      radius_(pen.width / 2),
      same_end_(std::min(std::sqrt(bound / (16 * radius_)), 0.05)),
      near_(near) {}

const Subpath& Circles::add(const Subpath& subpath) {
  Subpath moved;
  moved.is_closed = subpath.is_closed;
  for (Segment segment : subpath.segments) {
    const int last = static_cast<int>(segment.kind) + 1;
    const Point a = circles_[number_at(segment.p[0])].centre;
    const Point b = circles_[number_at(segment.p[last])].centre;
    // Handles go with their ends, so that tangents stay.
    if (last > 1) {
      segment.p[1] = segment.p[1] + (a - segment.p[0]);
    }
    if (last > 2) {
      segment.p[2] = segment.p[2] + (b - segment.p[3]);
    }
    segment.p[0] = a;
    segment.p[last] = b;
    bool moves = false;
    for (int i = 1; i <= last; ++i) {
      moves |= length(segment.p[i] - a) > near_;
    }
    if (moves) {
      moved.segments.push_back(segment);
    }
  }
  if (moved.segments.empty()) {
    const Point a = circles_[number_at(subpath.segments.front().p[0])].centre;
    moved.segments.push_back({Segment::Kind::line, {a, a}});
  }
  Path path;
  for (const Segment& segment : moved.segments) {
    const int count = chord_count(segment, near_ / 2);
    std::vector<Point> corners = {segment.p[0]};
    for (int i = 1; i <= count; ++i) {
      corners.push_back(point_on(segment, static_cast<double>(i) / count));
    }
    path.chords.push_back(std::move(corners));
  }
  path.subpath = std::move(moved);
  paths_.push_back(std::move(path));
  return paths_.back().subpath;
}

CoveredEnds Circles::covered(size_t number) const {
  if (pen_.cap != LineCap::round || paths_[number].subpath.is_closed) {
    return {};
  }
  return {is_covered(number, true), is_covered(number, false)};
}

bool Circles::is_covered(size_t number, bool is_start) const {
  const std::vector<Segment>& own = paths_[number].subpath.segments;
  const Point& at = is_start ? own.front().p[0] : last_point(own.back());
  for (size_t i = 0; i < paths_.size(); ++i) {
    const size_t count = paths_[i].subpath.segments.size();
    for (size_t k = 0; k < count; ++k) {
      // Of two ends that lie on each other the first one has its cap.
      const bool is_earlier = i < number || (i == number && !is_start);
      const bool is_own = i == number && k == (is_start ? 0 : count - 1);
      if (!is_own && covers(paths_[i], k, at, is_earlier)) {
        return true;
      }
    }
  }
  // A segment that ends where it begins.
  return !is_start && own.size() == 1 && length(own[0].p[0] - at) <= near_;
}

bool Circles::covers(const Path& other,
                     size_t segment,
                     const Point& at,
                     bool may_be_end) const {
  const std::vector<Point>& corners = other.chords[segment];
  const bool is_near_first = length(corners.front() - at) <= near_;
  const bool is_near_last = length(corners.back() - at) <= near_;
  if (is_near_first || is_near_last) {
    const bool is_end = !other.subpath.is_closed &&
                        ((is_near_first && segment == 0) ||
                         (is_near_last && segment + 1 == other.chords.size()));
    return is_end ? may_be_end : pen_.join == LineJoin::round;
  }
  for (size_t i = 1; i < corners.size(); ++i) {
    if (squared_distance_to_segment(at, corners[i - 1], corners[i]) <=
        near_ * near_) {
      return true;
    }
  }
  return false;
}

void Circles::note(const Point& centre, double from, double angle) {
  Circle& circle = circles_[number_at(centre)];
  circle.ends.push_back(within_turn(from));
  circle.ends.push_back(within_turn(from + angle));
}

std::vector<Segment> Circles::arc(const Point& centre,
                                  double from,
                                  double angle) {
  Circle& circle = circles_[number_at(centre)];
  sort_ends(circle);
  const std::vector<double>& ends = circle.ends;
  const auto on_circle = [&](double at) {
    return Point{std::cos(at), std::sin(at)};
  };
  const auto place = [&](const Point& p) {
    return circle.centre + radius_ * p;
  };
  std::vector<Segment> pieces;
  size_t i = nearest(ends, from);
  const size_t last = nearest(ends, from + angle);
  if (i == last && angle < kPi) {
    return pieces;
  }
  do {
    const size_t next = (i + 1) % ends.size();
    const double turn = ends[next] - ends[i] + (next == 0 ? kTurn : 0);
    const double k = arc_handle(turn);
    const Point a = on_circle(ends[i]);
    const Point b = on_circle(ends[next]);
    pieces.push_back({Segment::Kind::cubic,
                      {place(a), place(a + k * Point{-a.y, a.x}),
                       place(b - k * Point{-b.y, b.x}), place(b)}});
    i = next;
  } while (i != last);
  return pieces;
}

// The circle around `p`; a new one if there is none near.
size_t Circles::number_at(const Point& p) {
  size_t found = circles_.size();
  for (auto i = by_x_.lower_bound(p.x - near_);
       i != by_x_.end() && i->first <= p.x + near_; ++i) {
    if (length(circles_[i->second].centre - p) <= near_) {
      found = std::min(found, i->second);
    }
  }
  if (found == circles_.size()) {
    circles_.push_back({p, {}, false});
    by_x_.emplace(p.x, found);
  }
  return found;
}

void Circles::sort_ends(Circle& circle) const {
  if (circle.is_sorted) {
    return;
  }
  for (int i = 0; i <= 8; ++i) {
    circle.ends.push_back(i * kEighth);
  }
  std::sort(circle.ends.begin(), circle.ends.end());
  // Those of upright and level lines stay exact.
  std::vector<double> apart;
  for (const double end : circle.ends) {
    if (apart.empty() || end - apart.back() > same_end_) {
      apart.push_back(end);
    } else if (is_eighth(end) && !is_eighth(apart.back())) {
      apart.back() = end;
    }
  }
  apart.pop_back();  // a whole turn
  circle.ends = std::move(apart);
  circle.is_sorted = true;
}

}  // namespace inkcell::gen
