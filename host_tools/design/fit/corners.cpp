// Finds corners of loops, and replaces rounded points.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fit/loop.hpp"
#include "fit/parabola.hpp"

namespace inkcell::design {
namespace {

// The length that is examined on each side of a corner, beyond its reach. [u]
constexpr double kSide_u = 10;

// The same for nearly parallel sides, whose intersection is less certain. [u]
constexpr double kAcuteSide_u = 20;

// A tip is blunt if its sides meet farther than this from the edge. [u]
constexpr double kBlunt_u = 0.5;

// In a tip of less than 45 degrees distances are small far beyond the tip, too:
// they do not tell where it is.
constexpr double kAcuteCosine = -0.7;

// Tips narrower than this are sharp. [u]
constexpr double kSharp_u = 0.6;

// The step of the search for the end of a tip. [u]
constexpr double kTipStep_u = 0.25;

// For an arc, the distance at the intersection of its tangents is at least this
// share of the computed one.
constexpr double kArcShare = 0.6;

// Both halves of an arc turn alike, up to this ratio.
constexpr double kMostUneven = 3;

// The error of distances near a tip. [u]
constexpr double kFieldNoise_u = 0.1;

// Corners that turn by less are smooth to the field. [radians]
constexpr double kLeastTurn = 0.3;

// Cells spread half the turn of a corner over less of the length than this, in
// reaches. A long arc spreads it over one reach.
constexpr double kBendLength = 0.76;

// A tip that turns by less than a right angle, half of it over at least this
// many reaches, is an arc if its distances are an arc's. The corners of a blunt
// tip turn the contour further, or are nearer. [radians]
constexpr double kRoundTipTurn = 1.57;
constexpr double kRoundTipBend = 0.5;

// A corner is within this many times its reach of the contour's point.
constexpr double kMostExtension = 2.5;

struct Corner {
  double s = 0;  // arc length
  Point at;
  double reach = 0;  // points this near are removed
};

// Both sides of a corner, extrapolated; the arc length is 0 at the corner.
struct Sides {
  Parabola before;
  Parabola after;
};

class CornerFinder {
 public:
  CornerFinder(const CornerOptions& options, Loop& loop)
      : options_(options), loop_(loop), count_(loop.points.size()) {
    lengths_.push_back(0);
    angle_.push_back(0);
    for (size_t i = 0; i < count_; ++i) {
      const size_t next = (i + 1) % count_;
      lengths_.push_back(lengths_.back() + length(point(next) - point(i)));
      angle_.push_back(angle_.back() +
                       turn(loop_.tangents[i], loop_.tangents[next]));
    }
  }

  void run() {
    if (count_ < 8 || lengths_.back() < 6 * options_.reach) {
      return;
    }
    rate_all();
    choose();
    if (options_.is_exact) {
      mark();
    } else {
      replace();
    }
  }

 private:
  const Point& point(size_t i) const { return loop_.points[i % count_]; }

  // The place at arc length `s`, any number of rounds from the start: between
  // points i - 1 and i, a part of the way.
  struct Place {
    double rounds;
    size_t i;
    double part;
  };
  Place place_at(double s) const {
    const double rounds = std::floor(s / lengths_.back());
    const double within = s - rounds * lengths_.back();
    const auto next =
        std::upper_bound(lengths_.begin(), lengths_.end() - 1, within);
    const size_t i = static_cast<size_t>(next - lengths_.begin());
    const double span = lengths_[i] - lengths_[i - 1];
    return {rounds, i, span == 0 ? 0 : (within - lengths_[i - 1]) / span};
  }

  // The contour's direction at `s`. [radians]
  double angle_at(double s) const {
    const auto [rounds, i, part] = place_at(s);
    return rounds * angle_.back() + angle_[i - 1] +
           part * (angle_[i] - angle_[i - 1]);
  }

  // The turn at this point beyond that of its sides.
  double corner_turn(double s) const {
    const double w = options_.reach;
    const double a = angle_at(s - w);
    const double b = angle_at(s + w);
    const double before = (a - angle_at(s - 3 * w)) / (2 * w);
    const double after = (angle_at(s + 3 * w) - b) / (2 * w);
    const double both = before * after <= 0                    ? 0
                        : std::fabs(before) < std::fabs(after) ? before
                                                               : after;
    return b - a - 2 * w * both;
  }

  void rate_all() {
    for (size_t i = 0; i < count_; ++i) {
      ratings_.push_back(std::fabs(corner_turn(lengths_[i])));
    }
  }

  double gap(double from, double to) const {
    const double d = std::fabs(to - from);
    return std::min(d, lengths_.back() - d);
  }

  // Chooses the strongest first; others are at least its reach away. A corner
  // that is seen from several points is where most of the turn is in the
  // middle.
  void choose() {
    std::vector<size_t> order;
    for (size_t i = 0; i < count_; ++i) {
      if (ratings_[i] > options_.turn) {
        order.push_back(i);
      }
    }
    std::stable_sort(order.begin(), order.end(), [this](size_t a, size_t b) {
      return ratings_[a] > ratings_[b] + 1e-3;
    });
    for (const size_t i : order) {
      const double s = part_of_turn(lengths_[i], 0.5);
      const bool is_free = std::none_of(
          chosen_.begin(), chosen_.end(),
          [&](double other) { return gap(s, other) < 1.5 * options_.reach; });
      if (is_free) {
        chosen_.push_back(s);
      }
    }
    std::sort(chosen_.begin(), chosen_.end());
  }

  // The arc length at which this part of the turn around s is reached.
  double part_of_turn(double s, double part) const {
    double low = s - options_.reach;
    double high = s + options_.reach;
    const double a = angle_at(low);
    const double b = angle_at(high);
    const double wanted = a + part * (b - a);
    for (int round = 0; round < 30; ++round) {
      const double middle = (low + high) / 2;
      ((angle_at(middle) < wanted) == (b > a) ? low : high) = middle;
    }
    const double at = (low + high) / 2;
    return at - std::floor(at / lengths_.back()) * lengths_.back();
  }

  // The side of the corner at `s` in `direction`, 1 or -1, up to `room` away; s
  // = 0 at the corner.
  Parabola side(double s, double direction, double room, double extent) const {
    const double near = std::min(options_.reach, room / 2);
    const double far = std::min(std::max(options_.reach + extent, near), room);
    std::vector<double> lengths;
    std::vector<Point> points;
    const int steps = std::max(3, static_cast<int>((far - near) / 0.7));
    for (int i = 0; i <= steps; ++i) {
      const double d = direction * (near + (far - near) * i / steps);
      lengths.push_back(d);
      points.push_back(at(s + d));
    }
    return fit_parabola(lengths, points);
  }

  Point at(double s) const {
    const auto [rounds, i, part] = place_at(s);
    return point(i - 1) + part * (point(i) - point(i - 1));
  }

  Sides sides(size_t k, double extent) const {
    const double s = chosen_[k];
    double before = lengths_.back();
    double after = lengths_.back();
    if (chosen_.size() > 1) {
      const size_t n = chosen_.size();
      before = std::fmod(s - chosen_[(k + n - 1) % n] + lengths_.back(),
                         lengths_.back());
      after = std::fmod(chosen_[(k + 1) % n] - s + lengths_.back(),
                        lengths_.back());
    }
    return {side(s, -1, std::max(before - options_.reach, 0.5), extent),
            side(s, 1, std::max(after - options_.reach, 0.5), extent)};
  }

  // The largest distance of a corner from the contour's point. Cells and pixels
  // cut more off a sharp one: as 1 / sin of half its angle.
  double extension(const Point& in, const Point& out) const {
    const double sine = std::cos(turn(in, out) / 2);
    return kMostExtension * options_.reach /
           std::max(sine, options_.distance ? 0.25 : 0.6);
  }

  // The intersection of the sides of the corner at `s`.
  Point meeting(double s, const Sides& sides) const {
    const Parabola& a = sides.before;
    const Parabola& b = sides.after;
    double sa = 0;
    double sb = 0;
    for (int round = 0; round < 8; ++round) {
      const Point gap_now = b.at(sb) - a.at(sa);
      const Point da = a.slope(sa);
      const Point db = b.slope(sb);
      const double det = cross(da, db);
      if (std::fabs(det) < 0.05) {
        break;
      }
      sa += cross(gap_now, db) / det;
      sb += cross(gap_now, da) / det;
    }
    const Point found = 0.5 * (a.at(sa) + b.at(sb));
    const Point traced = at(s);
    const double most = extension(a.slope(sa), b.slope(sb));
    const bool is_near = std::fabs(sa) < most && std::fabs(sb) < most &&
                         length(found - traced) < most;
    return is_near ? found : traced;
  }

  // The tip of a corner with nearly parallel sides. Their intersection
  // amplifies errors many times, and squares of 1 u do not see the tip. Beyond
  // it, on the bisector, the distance is that from the tip. None if the sides
  // are too far from each other there.
  std::optional<Point> sharp_tip(double s, const Sides& sides) const {
    const Point in = unit(sides.before.slope(0));
    const Point out = unit(sides.after.slope(0));
    const Point along = unit(in - out);
    const double sign = cross(in, out) > 0 ? 1 : -1;  // ink in the tip, or none
    const Point from = at(s);
    const double most = extension(in, out);
    double beyond = -1;  // of the tip, from `from`
    for (double k = 0; k < most && beyond < 0; k += kTipStep_u) {
      const double d = sign * options_.distance(from + k * along);
      beyond = d < -kTipStep_u ? k + d : beyond;
    }
    if (beyond < 0) {
      return std::nullopt;
    }
    const auto there = [&](const Parabola& side) {
      const double speed = dot(side.slope(0), along);
      return side.at(
          speed == 0 ? 0 : (beyond - dot(side.c[0] - from, along)) / speed);
    };
    const double width = length(there(sides.before) - there(sides.after));
    return width < kSharp_u ? std::optional<Point>(from + beyond * along)
                            : std::nullopt;
  }

  // The two ends of a tip: the intersections of its sides with the line along
  // its end, or points of the contour if those are too far from the edge. None
  // if an arc explains the distances there better.
  std::vector<Corner> blunt_ends(double s, const Sides& sides) const {
    const double middle = part_of_turn(s, 0.5);
    const double step = options_.reach / 8;
    const Point along = unit(at(middle + step) - at(middle - step));
    const std::array<Point, 2> slopes = {sides.before.slope(0),
                                         sides.after.slope(0)};
    std::array<std::optional<Point>, 2> met;
    std::vector<Corner> ends;
    for (size_t i = 0; i < 2; ++i) {
      const double place = part_of_turn(s, i == 0 ? 0.25 : 0.75);
      const Parabola& side = i == 0 ? sides.before : sides.after;
      Corner corner = {place, at(place), options_.reach / 4};
      const std::optional<double> t = crossing(side, at(middle), along);
      if (t) {
        met[i] = side.at(*t);
        const bool is_near = std::fabs(*t) < options_.reach &&
                             std::fabs(options_.distance(*met[i])) <= kBlunt_u;
        corner.at = is_near ? *met[i] : corner.at;
      }
      ends.push_back(corner);
    }
    if (met[0] && met[1] && is_arc({*met[0], *met[1]}, along, slopes)) {
      ends.clear();
    }
    return ends;
  }

  // The intersection of a side with the line through `on` along `along`.
  static std::optional<double> crossing(const Parabola& side,
                                        const Point& on,
                                        const Point& along) {
    double t = 0;
    for (int round = 0; round < 8; ++round) {
      const double speed = cross(along, side.slope(t));
      if (std::fabs(speed) < 0.05) {
        return std::nullopt;
      }
      t -= cross(along, side.at(t) - on) / speed;
    }
    return t;
  }

  // Whether the edge is an arc that touches both sides and the line between
  // their intersections `met`. It stays inside of these by r (1 / cos(turn / 2)
  // - 1), where a blunt tip has its corners.
  bool is_arc(const std::array<Point, 2>& met,
              const Point& along,
              const std::array<Point, 2>& slopes) const {
    const double in = turn(slopes[0], along) / 2;
    const double out = turn(along, slopes[1]) / 2;
    const double tangents = std::tan(in) + std::tan(out);  // signed
    const bool is_even = in / out > 1 / kMostUneven && in / out < kMostUneven;
    if (!is_even || dot(met[1] - met[0], along) <= 0) {
      return false;
    }
    const double radius = length(met[1] - met[0]) / tangents;
    const auto fits = [&](const Point& p, double half) {
      return std::fabs(radius) * (1 / std::cos(half) - 1) < kFieldNoise_u ||
             stays_inside(p, radius, half);
    };
    return fits(met[0], in) && fits(met[1], out);
  }

  // Whether the contour bends smoothly where a corner at `met` was assumed: it
  // turns evenly, and stays inside of the intersection as an arc does.
  bool is_bend(double s, const Point& met, const Sides& sides) const {
    double bend = part_of_turn(s, 0.75) - part_of_turn(s, 0.25);
    bend += bend < 0 ? lengths_.back() : 0;
    const double turned = turn(sides.before.slope(0), sides.after.slope(0));
    const double radius = 2 * bend / turned;
    if (std::fabs(options_.distance(met)) > kBlunt_u) {
      return bend > kRoundTipBend * options_.reach &&
             std::fabs(turned) < kRoundTipTurn &&
             stays_inside(met, radius, turned / 2);
    }
    if (bend < kBendLength * options_.reach) {
      return false;
    }
    return std::fabs(turned) < kLeastTurn ||
           stays_inside(met, radius, turned / 2);
  }

  // Whether the edge stays inside of `met`, the intersection of two tangents of
  // an arc, as that arc does. Both numbers are negative where the contour turns
  // right.
  bool stays_inside(const Point& met, double radius, double half_turn) const {
    const double expected = radius * (1 / std::cos(half_turn) - 1);
    return -options_.distance(met) / expected > kArcShare;
  }

  // A corner, or the two ends of a blunt tip.
  std::vector<Corner> corners() const {
    std::vector<Corner> result;
    for (size_t k = 0; k < chosen_.size(); ++k) {
      Sides both = sides(k, kSide_u);
      const bool is_acute =
          options_.distance && dot(unit(both.before.slope(0)),
                                   unit(both.after.slope(0))) < kAcuteCosine;
      std::optional<Point> tip;
      if (is_acute) {
        tip = sharp_tip(chosen_[k], both);
        both = sides(k, kAcuteSide_u);
        const std::optional<Point> better = sharp_tip(chosen_[k], both);
        tip = better ? better : tip;
      }
      Corner corner = {chosen_[k], meeting(chosen_[k], both), options_.reach};
      const bool is_blunt = options_.distance &&
                            std::fabs(options_.distance(corner.at)) > kBlunt_u;
      if (is_blunt && !is_acute) {
        tip = sharp_tip(chosen_[k], both);
      }
      if (!tip && options_.distance && is_bend(chosen_[k], corner.at, both)) {
        continue;
      }
      if (tip || !is_blunt) {
        corner.at = tip.value_or(corner.at);
        result.push_back(corner);
        continue;
      }
      for (const Corner& end : blunt_ends(chosen_[k], both)) {
        result.push_back(end);
      }
    }
    std::sort(result.begin(), result.end(),
              [](const Corner& a, const Corner& b) { return a.s < b.s; });
    return result;
  }

  void mark() {
    for (const double s : chosen_) {
      const auto next =
          std::lower_bound(lengths_.begin(), lengths_.end() - 1, s);
      size_t i = static_cast<size_t>(next - lengths_.begin());
      if (i > 0 && s - lengths_[i - 1] < lengths_[i] - s) {
        --i;
      }
      loop_.corners.push_back(i % count_);
    }
    std::sort(loop_.corners.begin(), loop_.corners.end());
    loop_.corners.erase(std::unique(loop_.corners.begin(), loop_.corners.end()),
                        loop_.corners.end());
  }

  void replace() {
    if (chosen_.empty()) {
      return;
    }
    const std::vector<Corner> all = corners();
    const auto near_any = [&](double s) {
      return std::any_of(all.begin(), all.end(), [&](const Corner& corner) {
        return gap(s, corner.s) < corner.reach;
      });
    };
    Loop result;
    size_t i = 0;
    for (size_t k = 0; k <= all.size(); ++k) {
      const double until = k < all.size() ? all[k].s : lengths_.back();
      for (; i < count_ && lengths_[i] < until; ++i) {
        if (!near_any(lengths_[i])) {
          result.points.push_back(loop_.points[i]);
          result.tangents.push_back(loop_.tangents[i]);
        }
      }
      if (k < all.size()) {
        result.corners.push_back(result.points.size());
        result.points.push_back(all[k].at);
        result.tangents.push_back({0, 0});
      }
    }
    loop_ = std::move(result);
  }

  CornerOptions options_;
  Loop& loop_;
  size_t count_;
  std::vector<double> lengths_;  // up to each point; the last one is the length
  std::vector<double> angle_;    // likewise, unwrapped
  std::vector<double> ratings_;
  std::vector<double> chosen_;  // arc lengths, ascending
};

}  // namespace

void find_corners(const CornerOptions& options, Loop& loop) {
  CornerFinder(options, loop).run();
}

Loop sample_polygon(const std::vector<Point>& polygon, double spacing) {
  Loop loop;
  const size_t count = polygon.size();
  for (size_t i = 0; i < count; ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % count];
    const Point& before = polygon[(i + count - 1) % count];
    const Point out = unit(b - a);
    loop.points.push_back(a);
    loop.tangents.push_back(unit(unit(a - before) + out));
    const int pieces = static_cast<int>(std::ceil(length(b - a) / spacing));
    for (int k = 1; k < pieces; ++k) {
      loop.points.push_back(a + static_cast<double>(k) / pieces * (b - a));
      loop.tangents.push_back(out);
    }
  }
  return loop;
}

}  // namespace inkcell::design
