#include "fit/knots.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace inkcell::design {
namespace {

// Between knots the contour turns by about this, or is this long.
constexpr double kStepTurn = 0.16;  // [radians]
constexpr double kStepLength_u = 60;

// Straight parts are at least this long. [u]
constexpr double kLeastLine_u = 36;

// Curves may begin this far within a straight part. [u]
constexpr double kMostBack_u = 22;

// Straight parts turn by less than this. [radians]
constexpr double kMostBend = 0.02;

// Tangents are those of a parabola through the points within this distance, or
// less where the contour turns by more than this. [u, radians]
constexpr double kTangentReach_u = 12;
constexpr double kTangentTurn = 0.4;

// Extremes that stand out by less need no point of their own. [u]
constexpr double kLeastExtreme_u = 8;

// An extreme is this near to the points that are level. [u]
constexpr double kExtremeReach_u = 7;

// A level part longer than this has no extreme but its ends. [u]
constexpr double kMostPlateau_u = 40;

// A range of points on a line.
struct Straight {
  size_t first = 0;
  size_t last = 0;
  Point direction;
};

class KnotFinder {
 public:
  KnotFinder(const SmoothPiece& piece, const KnotOptions& options)
      : piece_(piece),
        options_(options),
        count_(piece.points.size()),
        lengths_(arc_lengths(piece.points)) {}

  std::vector<Knot> run() {
    add_steps();
    add_lines();
    places_.insert(0);
    places_.insert(count_ - 1);
    std::vector<Knot> knots;
    for (const size_t at : places_) {
      const auto on = std::find_if(
          straights_.begin(), straights_.end(),
          [at](const Straight& s) { return s.first <= at && at <= s.last; });
      knots.push_back(
          {at, on == straights_.end() ? tangent_at(at) : on->direction, false});
    }
    if (options_.extremes) {
      add_extremes(true, knots);
      add_extremes(false, knots);
    }
    std::stable_sort(knots.begin(), knots.end(),
                     [](const Knot& a, const Knot& b) { return a.at < b.at; });
    return without_crowds(std::move(knots));
  }

 private:
  const Point& p(size_t i) const { return piece_.points[i]; }

  void add_steps() {
    double turned = 0;
    double went = 0;
    for (size_t i = 1; i + 1 < count_; ++i) {
      const Point in = p(i) - p(i - 1);
      turned += turn(piece_.tangents[i - 1], piece_.tangents[i]);
      went += length(in);
      if (std::fabs(turned) > kStepTurn || went > kStepLength_u) {
        places_.insert(i);
        turned = 0;
        went = 0;
      }
    }
  }

  // Whether the points from i to j are on a line.
  bool is_line(size_t i, size_t j) const {
    const double limit = options_.tolerance / 2;
    for (size_t k = i + 1; k < j; ++k) {
      if (distance_to_piece(p(k), p(i), p(j)) > limit) {
        return false;
      }
    }
    return true;
  }

  // The longest line from i: doubles the length until it fails, then bisects.
  size_t line_from(size_t i) const {
    size_t good = i + 1;
    size_t step = 1;
    while (good + step < count_ && is_line(i, good + step)) {
      good += step;
      step *= 2;
    }
    for (; step > 0; step /= 2) {
      if (good + step < count_ && is_line(i, good + step)) {
        good += step;
      }
    }
    return good;
  }

  // The turn between i and j without a margin at both ends, which are bent by
  // adjacent curves. [radians]
  double turn_within(size_t i, size_t j) const {
    const size_t off = (j - i) / 8;
    return std::fabs(
        turn(p(i + 2 * off) - p(i + off), p(j - off) - p(j - 2 * off)));
  }

  size_t index(double s) const {
    return static_cast<size_t>(
        std::lower_bound(lengths_.begin(), lengths_.end(), s) -
        lengths_.begin());
  }

  void add_lines() {
    for (size_t i = 0; i + 1 < count_;) {
      const size_t j = line_from(i);
      if (lengths_[j] - lengths_[i] >= kLeastLine_u &&
          turn_within(i, j) < kMostBend) {
        const size_t off = (j - i) / 4;
        straights_.push_back({i, j, unit(p(j - off) - p(i + off))});
        // Adjacent curves are level with the line slightly inside of its ends.
        for (double back = 0;
             back < (lengths_[j] - lengths_[i]) / 3 && back < kMostBack_u;
             back = 2 * back + 3) {
          places_.insert(index(lengths_[i] + back));
          places_.insert(index(lengths_[j] - back));
        }
      }
      i += std::max<size_t>(1, (j - i) / 3);
    }
  }

  // The turn of the contour within `reach` of a point. [radians]
  double turn_around(size_t at, double reach) const {
    const size_t last = std::min(index(lengths_[at] + reach), count_ - 1);
    return std::fabs(turn(piece_.tangents[index(lengths_[at] - reach)],
                          piece_.tangents[last]));
  }

  // Least squares: p = a + b s + c s^2 of the arc length s; b is the tangent.
  Point tangent_at(size_t at) const {
    double reach = kTangentReach_u;
    if (!piece_.is_closed) {
      // One-sided tangents are bad: use less reach near the ends.
      const double room =
          std::min(lengths_[at], lengths_.back() - lengths_[at]);
      reach = std::max(std::min(reach, room), 2.0);
    }
    while (reach > 2 && turn_around(at, reach) > kTangentTurn) {
      reach *= 0.7;
    }
    const size_t first = index(lengths_[at] - reach);
    const size_t last = std::min(index(lengths_[at] + reach), count_ - 1);
    double n = 0, s1 = 0, s2 = 0, s3 = 0, s4 = 0;
    Point q0, q1, q2;
    const auto add = [&](double s, const Point& point) {
      n += 1;
      s1 += s;
      s2 += s * s;
      s3 += s * s * s;
      s4 += s * s * s * s;
      q0 = q0 + point;
      q1 = q1 + s * point;
      q2 = q2 + s * s * point;
    };
    for (size_t i = first; i <= last; ++i) {
      add(lengths_[i] - lengths_[at], p(i) - p(at));
    }
    if (piece_.is_closed) {
      for (size_t i = 1;
           i < count_ && lengths_[i] + lengths_.back() - lengths_[at] < reach;
           ++i) {
        add(lengths_[i] + lengths_.back() - lengths_[at], p(i) - p(at));
      }
      for (size_t i = count_ - 1;
           i-- > 0 && lengths_[i] - lengths_.back() - lengths_[at] > -reach;) {
        add(lengths_[i] - lengths_.back() - lengths_[at], p(i) - p(at));
      }
    }
    // Cramer's rule for b.
    const double det = n * (s2 * s4 - s3 * s3) - s1 * (s1 * s4 - s3 * s2) +
                       s2 * (s1 * s3 - s2 * s2);
    if (n < 5 || std::fabs(det) < 1e-6) {
      return piece_.tangents[at];
    }
    const double k0 = -(s1 * s4 - s2 * s3);
    const double k1 = n * s4 - s2 * s2;
    const double k2 = -(n * s3 - s1 * s2);
    return unit((1 / det) * (k0 * q0 + k1 * q1 + k2 * q2));
  }

  double value(size_t i, bool in_x) const { return in_x ? p(i).x : p(i).y; }

  // Extremes that stand out on both sides.
  void add_extremes(bool in_x, std::vector<Knot>& knots) const {
    size_t low = 0;
    size_t high = 0;
    int direction = 0;  // 1: rising since `low`
    const auto emit = [&](size_t at) { add_extreme(at, in_x, knots); };
    for (size_t i = 1; i < count_; ++i) {
      const double v = value(i, in_x);
      if (v > value(high, in_x)) {
        high = i;
      }
      if (v < value(low, in_x)) {
        low = i;
      }
      if (direction >= 0 && v < value(high, in_x) - kLeastExtreme_u) {
        if (direction > 0) {
          emit(high);
        }
        direction = -1;
        low = i;
      } else if (direction <= 0 && v > value(low, in_x) + kLeastExtreme_u) {
        if (direction < 0) {
          emit(low);
        }
        direction = 1;
        high = i;
      }
      if (direction > 0 && v == value(high, in_x)) {
        low = i;
      }
      if (direction < 0 && v == value(low, in_x)) {
        high = i;
      }
    }
  }

  // The place near the points `first` to `last` where the tangent is horizontal
  // or vertical; their middle if there is none.
  size_t turning_point(size_t first, size_t last, bool in_x) const {
    const auto slope = [&](size_t i) {
      const Point t = tangent_at(i);
      return in_x ? t.x : t.y;
    };
    size_t low = std::max<size_t>(index(lengths_[first] - kExtremeReach_u), 1);
    size_t high = std::min(index(lengths_[last] + kExtremeReach_u), count_ - 2);
    const bool rises = slope(low) < slope(high);
    if (low >= high || slope(low) * slope(high) > 0) {
      return index((lengths_[first] + lengths_[last]) / 2);
    }
    while (high - low > 1) {
      const size_t middle = (low + high) / 2;
      ((slope(middle) < 0) == rises ? low : high) = middle;
    }
    return low;
  }

  void add_extreme(size_t at, bool in_x, std::vector<Knot>& knots) const {
    size_t first = at;
    size_t last = at;
    const double level = options_.tolerance / 4;
    while (first > 0 &&
           std::fabs(value(first - 1, in_x) - value(at, in_x)) < level) {
      --first;
    }
    while (last + 1 < count_ &&
           std::fabs(value(last + 1, in_x) - value(at, in_x)) < level) {
      ++last;
    }
    if (lengths_[last] - lengths_[first] > kMostPlateau_u) {
      return;
    }
    const size_t turns = turning_point(first, last, in_x);
    if (turns == 0 || turns + 1 >= count_) {
      return;
    }
    const Point t = tangent_at(turns);
    const Point level_tangent =
        in_x ? Point{0, t.y < 0 ? -1.0 : 1.0} : Point{t.x < 0 ? -1.0 : 1.0, 0};
    if (dot(t, level_tangent) > 0.95) {
      knots.push_back({turns, level_tangent, true});
    }
  }

  // Drops other knots beside a forced one, which would lead to tiny pieces.
  std::vector<Knot> without_crowds(std::vector<Knot> knots) const {
    std::vector<Knot> kept;
    for (size_t i = 0; i < knots.size(); ++i) {
      const bool is_end = knots[i].at == 0 || knots[i].at == count_ - 1;
      bool drop = false;
      for (const Knot& other : knots) {
        const double gap =
            std::fabs(lengths_[other.at] - lengths_[knots[i].at]);
        drop = drop ||
               (other.is_forced && !knots[i].is_forced && !is_end && gap < 3);
      }
      const bool repeats = !kept.empty() && kept.back().at == knots[i].at;
      if (!drop && !repeats) {
        kept.push_back(knots[i]);
      } else if (repeats && knots[i].is_forced) {
        kept.back() = knots[i];
      }
    }
    return kept;
  }

  const SmoothPiece& piece_;
  const KnotOptions& options_;
  size_t count_;
  std::vector<double> lengths_;
  std::set<size_t> places_;
  std::vector<Straight> straights_;
};

}  // namespace

std::vector<Knot> find_knots(const SmoothPiece& piece,
                             const KnotOptions& options) {
  return KnotFinder(piece, options).run();
}

}  // namespace inkcell::design
