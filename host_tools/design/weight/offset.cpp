#include "weight/offset.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fit/cubic_fit.hpp"
#include "shape/flatten.hpp"

namespace inkcell::design {
namespace {

constexpr int kChords = 12;        // of a curve that moves
constexpr double kSmooth = 0.996;  // cosine of the turn of a smooth joint
constexpr double kLevel = 0.9995;  // cosine: a normal along an axis
constexpr double kMiter = 6;       // a corner's length in movements
constexpr double kNothing = 1e-6;  // [u]

Point place_of(const GlyphPoint& point) {
  return {point.x, point.y};
}

Point chord_of(const gen::Segment& curve) {
  return end_of(curve) - curve.p[0];
}

// The unit tangent; of a curve whose handle has no length towards the next one.
Point tangent_at(const gen::Segment& curve, double t) {
  const int degree = degree_of(curve);
  const int first = t < 0.5 ? 0 : degree;
  if (t > 0 && t < 1) {
    constexpr double kStep = 1e-4;
    return gen::direction(point_on(curve, t + kStep) -
                          point_on(curve, t - kStep));
  }
  for (int i = 1; i <= degree; ++i) {
    const Point d = first == 0 ? curve.p[i] - curve.p[0]
                               : curve.p[degree] - curve.p[degree - i];
    if (length(d) > kNothing) {
      return gen::direction(d);
    }
  }
  return {};
}

bool is_axis(const Point& n) {
  return std::abs(n.x) > kLevel || std::abs(n.y) > kLevel;
}

// A piece after its movement, as a polyline.
struct Path {
  std::vector<Point> points;
  Point begin;  // unit tangents of its ends
  Point end;
};

struct Cut {
  Point at;
  double place = 0;  // on the path: number of the point before and the rest
  bool is_found = false;
};

std::optional<Point> meeting(const Point& a,
                             const Point& da,
                             const Point& b,
                             const Point& db) {
  const double area = cross(da, db);
  if (std::abs(area) < 1e-3) {
    return std::nullopt;
  }
  return a + (cross(b - a, db) / area) * da;
}

// Where the end of `a` and the start of `b` meet, continued by `reach`.
std::pair<Cut, Cut> meet(const Path& a, const Path& b, double reach) {
  std::vector<Point> left = a.points;
  left.push_back(left.back() + reach * a.end);
  std::vector<Point> right = b.points;
  right.insert(right.begin(), right.front() - reach * b.begin);
  std::pair<Cut, Cut> best;
  double least = kMiter * kMiter * 1e6;
  for (size_t i = left.size() - 1; i-- > 0;) {
    const Point d = left[i + 1] - left[i];
    for (size_t k = 0; k + 1 < right.size(); ++k) {
      const Point e = right[k + 1] - right[k];
      const double area = cross(d, e);
      if (std::abs(area) < 1e-9) {
        continue;
      }
      const double s = cross(right[k] - left[i], e) / area;
      const double t = cross(right[k] - left[i], d) / area;
      if (s < -1e-9 || s > 1 + 1e-9 || t < -1e-9 || t > 1 + 1e-9) {
        continue;
      }
      const Point at = left[i] + s * d;
      const double away =
          length(at - a.points.back()) + length(at - b.points.front());
      if (away < least) {
        least = away;
        best = {{at, static_cast<double>(i) + s, true},
                {at, static_cast<double>(k) + t - 1, true}};
      }
    }
  }
  if (!best.first.is_found) {
    const Point at = gen::middle(a.points.back(), b.points.front());
    best = {{at, static_cast<double>(a.points.size() - 1), false},
            {at, 0, false}};
  }
  return best;
}

class Mover {
 public:
  Mover(const PointContour& contour,
        const std::vector<Piece>& pieces,
        const Growth& growth,
        bool is_clockwise)
      : result_(contour),
        pieces_(pieces),
        growth_(growth),
        is_clockwise_(is_clockwise),
        is_gone_(pieces.size()) {}

  PointContour run() {
    const size_t count = pieces_.size();
    for (size_t i = 0; i < count; ++i) {
      paths_.push_back(path_of(i));
    }
    begins_.resize(count);
    ends_.resize(count);
    for (size_t i = 0; i < count; ++i) {
      find_gone(i);
    }
    for (size_t i = 0; i < count; ++i) {
      if (!is_gone_[i]) {
        join(i, next_of(i));
      }
    }
    for (size_t i = 0; i < count; ++i) {
      place(i);
    }
    return result_;
  }

 private:
  size_t next_of(size_t i) const {
    size_t next = (i + 1) % pieces_.size();
    while (is_gone_[next]) {
      next = (next + 1) % pieces_.size();
    }
    return next;
  }

  const Piece& after(size_t i) const { return pieces_[next_of(i)]; }

  double reach() const {  // of corners
    return kMiter *
           std::max({std::abs(growth_.across), std::abs(growth_.up), 1.0});
  }

  // Short curves after piece i, such as those that round a notch, would be a
  // loop where the pieces around them cross.
  void find_gone(size_t i) {
    const size_t count = pieces_.size();
    double along = 0;
    size_t gone = 0;
    for (size_t k = 1; k + 2 < count && !is_gone_[i]; ++k) {
      const Piece& curve = pieces_[(i + k) % count];
      along += length(chord_of(curve.curve));
      if (curve.controls.empty() || along > reach()) {
        break;
      }
      if (meet(paths_[i], paths_[(i + k + 1) % count], 0).first.is_found) {
        gone = k;
      }
    }
    for (; gone > 0; --gone) {
      is_gone_[(i + gone) % count] = true;
    }
  }

  bool is_smooth(size_t i) const {
    const Point in = tangent_at(pieces_[i].curve, 1);
    const Point out = tangent_at(after(i).curve, 0);
    return dot(in, out) > kSmooth;
  }

  // The extra movement of the joint after piece i, for that piece or for the
  // next one.
  double extra_at(size_t i, bool is_next) const {
    const Piece& own = is_next ? after(i) : pieces_[i];
    if (!is_smooth(i)) {
      return own.extra;
    }
    return is_axis(normal_at(own.curve, is_next ? 0 : 1, is_clockwise_))
               ? 0
               : (pieces_[i].extra + after(i).extra) / 2;
  }

  Path path_of(size_t i) const {
    const Piece& piece = pieces_[i];
    const size_t before = (i + pieces_.size() - 1) % pieces_.size();
    const double e0 = extra_at(before, true);
    const double e1 = extra_at(i, false);
    const bool is_line = piece.curve.kind == gen::Segment::Kind::line;
    const int chords = is_line ? 1 : kChords;
    Path path;
    for (int k = 0; k <= chords; ++k) {
      const double t = static_cast<double>(k) / chords;
      const Point n = normal_at(piece.curve, t, is_clockwise_);
      const double e =
          e0 + t * (e1 - e0) + 4 * t * (1 - t) * (piece.extra - (e0 + e1) / 2);
      path.points.push_back(point_on(piece.curve, t) + growth_.of(n) +
                            (is_line ? (k == 0 ? e0 : e1) : e) * n);
    }
    path.begin = tangent_at(piece.curve, 0);
    path.end = tangent_at(piece.curve, 1);
    return path;
  }

  void join(size_t i, size_t next) {
    const Path& a = paths_[i];
    const Path& b = paths_[next];
    if (is_smooth(i)) {
      const Point at = gen::middle(a.points.back(), b.points.front());
      ends_[i] = {at, static_cast<double>(a.points.size() - 1), true};
      begins_[next] = {at, 0, true};
      return;
    }
    std::tie(ends_[i], begins_[next]) = meet(a, b, reach());
    for (size_t gone = (i + 1) % pieces_.size(); gone != next;
         gone = (gone + 1) % pieces_.size()) {
      ends_[gone] = ends_[i];
    }
  }

  // The moved piece's points between both joints.
  std::vector<Point> part_of(size_t i) const {
    std::vector<Point> part = {begins_[i].at};
    for (size_t k = 0; k < paths_[i].points.size(); ++k) {
      const auto at = static_cast<double>(k);
      if (at > begins_[i].place + 0.05 && at < ends_[i].place - 0.05) {
        part.push_back(paths_[i].points[k]);
      }
    }
    part.push_back(ends_[i].at);
    return part;
  }

  void set(size_t point, const Point& to) {
    result_.points[point].x = to.x;
    result_.points[point].y = to.y;
  }

  void place(size_t i) {
    const Piece& piece = pieces_[i];
    for (const size_t end : piece.ends) {
      set(end, ends_[i].at);
    }
    if (is_gone_[i]) {
      for (const size_t control : piece.controls) {
        set(control, ends_[i].at);
      }
      return;
    }
    if (piece.controls.empty()) {
      return;
    }
    const std::vector<Point> part = part_of(i);
    const Point begin = direction_at(i, part, true);
    const Point end = direction_at(i, part, false);
    const gen::Segment& curve = piece.curve;
    const double was = length(chord_of(curve));
    const double scale =
        was > kNothing ? length(part.back() - part.front()) / was : 1;
    if (piece.controls.size() == 1) {
      const auto control = meeting(part.front(), begin, part.back(), end);
      const bool is_between = control &&
                              dot(*control - part.front(), begin) > 0 &&
                              dot(part.back() - *control, end) > 0;
      set(piece.controls[0],
          is_between
              ? *control
              : gen::middle(part.front(), part.back()) +
                    scale * (curve.p[1] - gen::middle(curve.p[0], curve.p[2])));
      return;
    }
    place_handles(piece, part, begin, end, scale);
  }

  // Of the tangent where a joint is smooth or lies beyond the curve.
  Point direction_at(size_t i,
                     const std::vector<Point>& part,
                     bool is_begin) const {
    const Path& path = paths_[i];
    const auto last = static_cast<double>(path.points.size() - 1);
    const bool is_cut =
        is_begin ? begins_[i].place > 0.01 : ends_[i].place < last - 0.01;
    if (!is_cut || part.size() < 3) {
      return is_begin ? path.begin : path.end;
    }
    return is_begin
               ? gen::direction(part[1] - part[0])
               : gen::direction(part[part.size() - 1] - part[part.size() - 2]);
  }

  void place_handles(const Piece& piece,
                     const std::vector<Point>& part,
                     const Point& begin,
                     const Point& end,
                     double scale) {
    const gen::Segment& curve = piece.curve;
    Point first =
        part.front() + (scale * length(curve.p[1] - curve.p[0])) * begin;
    Point second =
        part.back() - (scale * length(curve.p[3] - curve.p[2])) * end;
    if (part.size() >= 6) {
      const std::vector<double> lengths = arc_lengths(part);
      constexpr double kWorst_u = 2;
      const FittedCubic fitted =
          fit_cubic({part.data(), lengths.data(), part.size(), begin, end}, 0);
      if (fitted.worst < kWorst_u) {
        first = fitted.segment.p[1];
        second = fitted.segment.p[2];
      }
    }
    set(piece.controls[0], first);
    set(piece.controls[1], second);
  }

  PointContour result_;
  const std::vector<Piece>& pieces_;
  Growth growth_;
  bool is_clockwise_;
  std::vector<bool> is_gone_;
  std::vector<Path> paths_;
  std::vector<Cut> begins_;
  std::vector<Cut> ends_;
};

}  // namespace

std::vector<Piece> pieces_of(const PointContour& contour) {
  const std::vector<GlyphPoint>& points = contour.points;
  const size_t count = points.size();
  std::vector<Piece> pieces;
  if (contour.open() || count < 2) {
    return pieces;
  }
  const auto first_on = static_cast<size_t>(
      std::find_if(points.begin(), points.end(),
                   [](const GlyphPoint& p) { return p.on_curve(); }) -
      points.begin());
  const bool is_all_implied = first_on == count;
  Point at = is_all_implied ? gen::middle(place_of(points.back()),
                                          place_of(points.front()))
                            : place_of(points[first_on]);
  std::vector<size_t> controls;
  const auto add = [&](const Point& to, std::vector<size_t> ends) {
    if (controls.empty() && length(to - at) <= kNothing && !pieces.empty()) {
      pieces.back().ends.insert(pieces.back().ends.end(), ends.begin(),
                                ends.end());
      return;
    }
    Piece piece;
    piece.controls = controls;
    piece.ends = std::move(ends);
    piece.curve.kind = static_cast<gen::Segment::Kind>(controls.size());
    piece.curve.p[0] = at;
    for (size_t i = 0; i < controls.size(); ++i) {
      piece.curve.p[i + 1] = place_of(points[controls[i]]);
    }
    piece.curve.p[controls.size() + 1] = to;
    pieces.push_back(std::move(piece));
    controls.clear();
    at = to;
  };
  const size_t begin = is_all_implied ? count - 1 : first_on;
  for (size_t i = 1; i <= count; ++i) {
    const size_t k = (begin + i) % count;
    const size_t next = (k + 1) % count;
    if (points[k].on_curve()) {
      add(place_of(points[k]), {k});
      continue;
    }
    controls.push_back(k);
    size_t on = next;
    while (!points[on].on_curve() && on != k) {
      on = (on + 1) % count;
    }
    const bool is_cubic = points[on].type == PointType::curve;
    if (!points[next].on_curve() && !is_cubic) {
      add(gen::middle(place_of(points[k]), place_of(points[next])), {});
    }
  }
  return pieces;
}

Point normal_at(const gen::Segment& curve, double t, bool is_clockwise) {
  const Point d = tangent_at(curve, t);
  return is_clockwise ? Point{-d.y, d.x} : Point{d.y, -d.x};
}

PointContour moved(const PointContour& contour,
                   const std::vector<Piece>& pieces,
                   const Growth& growth,
                   bool is_clockwise) {
  return pieces.size() < 2 ? contour
                           : Mover(contour, pieces, growth, is_clockwise).run();
}

}  // namespace inkcell::design
