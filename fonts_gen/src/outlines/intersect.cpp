#include "outlines/intersect.hpp"

#include <algorithm>
#include <cmath>

#include "outlines/curves.hpp"
#include "shape/flatten.hpp"
#include "shape/points.hpp"

namespace inkcell {
namespace gen {
namespace {

// Chords take the place of curves that are as near as this. [u]
constexpr double kFlat_u = 1e-6;
// How far beyond its end a chord may meet another. [u]
constexpr double kSlack_u = 1e-5;
// Pairs of parts looked at. Two curves that cross take some 40, curves that
// run along each other any number.
constexpr int kMostPairs = 4000;

struct Part {
  Segment curve;
  double t0;
  double t1;
};

bool boxes_meet(const Segment& a, const Segment& b) {
  const Point& a1 = end_of(a);
  const Point& b1 = end_of(b);
  return std::max(a.p[0].x, a1.x) + kSlack_u >= std::min(b.p[0].x, b1.x) &&
         std::max(b.p[0].x, b1.x) + kSlack_u >= std::min(a.p[0].x, a1.x) &&
         std::max(a.p[0].y, a1.y) + kSlack_u >= std::min(b.p[0].y, b1.y) &&
         std::max(b.p[0].y, b1.y) + kSlack_u >= std::min(a.p[0].y, a1.y);
}

// Whether a line along the chord of `a` has the two on its two sides.
bool chord_parts(const Segment& a, const Segment& b) {
  const Point d = end_of(a) - a.p[0];
  const double slack = kSlack_u * length(d);
  double low_a = 0;
  double high_a = 0;
  for (int i = 1; i < degree_of(a); ++i) {
    const double side = cross(d, a.p[i] - a.p[0]);
    low_a = std::min(low_a, side);
    high_a = std::max(high_a, side);
  }
  double low_b = cross(d, b.p[0] - a.p[0]);
  double high_b = low_b;
  for (int i = 1; i <= degree_of(b); ++i) {
    const double side = cross(d, b.p[i] - a.p[0]);
    low_b = std::min(low_b, side);
    high_b = std::max(high_b, side);
  }
  return low_b > high_a + slack || high_b < low_a - slack;
}

bool may_meet(const Segment& a, const Segment& b) {
  return boxes_meet(a, b) && !chord_parts(a, b) && !chord_parts(b, a);
}

// The parameter of `p` on the chord from `a`, if it lies on it.
bool on_chord(const Point& p, const Point& a, const Point& d, double& t) {
  const double size = dot(d, d);
  if (size == 0) {
    return false;
  }
  t = dot(p - a, d) / size;
  const double slack = kSlack_u / std::sqrt(size);
  return t >= -slack && t <= 1 + slack &&
         std::fabs(cross(p - a, d)) <= kSlack_u * std::sqrt(size);
}

class Search {
 public:
  explicit Search(std::vector<Meeting>& meetings) : meetings_(meetings) {}

  bool run(const Segment& a, const Segment& b) {
    pending_.push_back({{a, 0, 1}, {b, 0, 1}});
    for (int pairs = 0; !pending_.empty(); ++pairs) {
      if (pairs > kMostPairs) {
        return false;
      }
      const Pair pair = pending_.back();
      pending_.pop_back();
      if (may_meet(pair.a.curve, pair.b.curve)) {
        look_at(pair);
      }
    }
    return true;
  }

 private:
  struct Pair {
    Part a;
    Part b;
  };

  static Part half(const Part& part, double t0, double t1) {
    const double size = part.t1 - part.t0;
    return {part_of(part.curve, t0, t1), part.t0 + t0 * size,
            part.t0 + t1 * size};
  }

  void look_at(const Pair& pair) {
    const int chords_a = chord_count(pair.a.curve, kFlat_u);
    const int chords_b = chord_count(pair.b.curve, kFlat_u);
    if (chords_a == 1 && chords_b == 1) {
      meet_chords(pair.a, pair.b);
    } else if (chords_a >= chords_b) {
      pending_.push_back({half(pair.a, 0, 0.5), pair.b});
      pending_.push_back({half(pair.a, 0.5, 1), pair.b});
    } else {
      pending_.push_back({pair.a, half(pair.b, 0, 0.5)});
      pending_.push_back({pair.a, half(pair.b, 0.5, 1)});
    }
  }

  void add(const Part& a, const Part& b, double t, double u) {
    const double s = std::clamp(t, 0.0, 1.0);
    const double v = std::clamp(u, 0.0, 1.0);
    meetings_.push_back({a.t0 + s * (a.t1 - a.t0), b.t0 + v * (b.t1 - b.t0)});
  }

  void meet_chords(const Part& a, const Part& b) {
    const Point& a0 = a.curve.p[0];
    const Point& b0 = b.curve.p[0];
    const Point da = end_of(a.curve) - a0;
    const Point db = end_of(b.curve) - b0;
    double t = 0;
    for (const double end : {0.0, 1.0}) {
      if (on_chord(a0 + end * da, b0, db, t)) {
        add(a, b, end, t);
      }
      if (on_chord(b0 + end * db, a0, da, t)) {
        add(a, b, t, end);
      }
    }
    const double across = cross(da, db);
    if (across != 0) {
      const double s = cross(b0 - a0, db) / across;
      const double v = cross(b0 - a0, da) / across;
      if (s >= 0 && s <= 1 && v >= 0 && v <= 1) {
        add(a, b, s, v);
      }
    }
  }

  std::vector<Meeting>& meetings_;
  std::vector<Pair> pending_;
};

}  // namespace

bool find_meetings(const Segment& a,
                   const Segment& b,
                   std::vector<Meeting>& meetings) {
  return Search(meetings).run(a, b);
}

}  // namespace gen
}  // namespace inkcell
