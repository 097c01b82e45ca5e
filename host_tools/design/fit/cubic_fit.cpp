#include "fit/cubic_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace inkcell::design {
namespace {

// Points used by least squares.
constexpr size_t kMostPoints = 32;
using Numbers = std::array<double, kMostPoints>;

// Added to divisors, which then are not 0.
constexpr double kTiny = 1e-100;

constexpr int kRounds = 40;
constexpr int kIdleRounds = 5;

// Keeps handles in place if no point determines them.
constexpr double kDamping = 1e-6;

// A curve this many times beyond the limit after five rounds is given up.
constexpr double kHopeless = 10;

// A step that makes handles unusable is halved, down to this share.
constexpr double kLeastStep = 0.05;

// A curve this many times beyond the limit misses it, whatever the skipped
// points are.
constexpr double kMissed = 1.5;

// Points whose distances from the curve are measured at the end.
constexpr size_t kMostMeasured = 64;

// A cubic as a polynomial of its parameter.
class PowerForm {
 public:
  PowerForm() = default;
  explicit PowerForm(const gen::Segment& cubic) {
    const Point* p = cubic.p;
    c_[0] = p[0];
    c_[1] = 3 * (p[1] - p[0]);
    c_[2] = 3 * (p[2] - 2 * p[1] + p[0]);
    c_[3] = p[3] - p[0] + 3 * (p[1] - p[2]);
  }

  Point at(double t) const {
    return c_[0] + t * (c_[1] + t * (c_[2] + t * c_[3]));
  }
  Point slope(double t) const {
    return c_[1] + t * (2 * c_[2] + 3 * t * c_[3]);
  }
  Point bend(double t) const { return 2 * c_[2] + 6 * t * c_[3]; }

 private:
  Point c_[4];
};

class CubicFit {
 public:
  CubicFit(const Stretch& stretch, double limit)
      : stretch_(stretch), limit_(limit) {
    const size_t step =
        std::max<size_t>(1, (stretch.count + kMostPoints - 1) / kMostPoints);
    const size_t last = stretch.count - 1;
    length_ = stretch.lengths[last] - stretch.lengths[0];
    for (size_t i = step; i < last; i += step) {
      x_[count_] = stretch.points[i].x;
      y_[count_] = stretch.points[i].y;
      t_[count_++] = (stretch.lengths[i] - stretch.lengths[0]) / length_;
    }
    cubic_.kind = gen::Segment::Kind::cubic;
    cubic_.p[0] = stretch.points[0];
    cubic_.p[3] = stretch.points[last];
  }

  FittedCubic run() {
    set_basis();
    solve();
    double error = project();
    gen::Segment best = cubic_;
    int idle = 0;  // rounds with little gain
    for (int round = 0; round < kRounds && idle < kIdleRounds; ++round) {
      if (round == kIdleRounds && error > kHopeless * limit_) {
        break;
      }
      improve();
      const double now = project();
      idle = now > 0.95 * error ? idle + 1 : 0;
      if (now < error) {
        best = cubic_;
        error = now;
      }
    }
    cubic_ = best;
    FittedCubic result;
    result.segment = cubic_;
    if (error > kMissed * limit_) {
      result.worst = error;
    } else {
      measure(result);
    }
    return result;
  }

 private:
  // P1 = P0 + handle, along a direction or free; P2 likewise. The unknowns are
  // the lengths or the coordinates of the handles: up to four.
  void set_basis() {
    const auto put = [this](const Point& direction, bool is_second) {
      basis_[unknowns_] = direction;
      second_[unknowns_++] = is_second;
    };
    for (const bool is_second : {false, true}) {
      const std::optional<Point>& t = is_second ? stretch_.end : stretch_.begin;
      if (t) {
        put(is_second ? -1.0 * *t : *t, is_second);
      } else {
        put({1, 0}, is_second);
        put({0, 1}, is_second);
      }
    }
  }

  // Weight of an unknown at the parameter t.
  double weight(size_t unknown, double t) const {
    const double s = 1 - t;
    return 3 * s * t * (second_[unknown] ? t : s);
  }

  // Least squares of the distances between points and the curve at their
  // parameters.
  void solve() {
    const Point& p0 = cubic_.p[0];
    const Point& p3 = cubic_.p[3];
    double m[4][5] = {};
    for (size_t i = 0; i < count_; ++i) {
      const double t = t_[i];
      const double w0 = (1 - t) * (1 - t) * (1 + 2 * t);
      const Point rest = Point{x_[i], y_[i]} - (w0 * p0 + (1 - w0) * p3);
      for (size_t r = 0; r < unknowns_; ++r) {
        const Point row = weight(r, t) * basis_[r];
        for (size_t c = r; c < unknowns_; ++c) {
          m[r][c] += weight(c, t) * dot(row, basis_[c]);
        }
        m[r][4] += dot(row, rest);
      }
    }
    mirror(m);
    double x[4] = {};
    if (eliminate(m, unknowns_, x) && usable(x)) {
      set_handles(x);
    } else {
      thirds();
    }
  }

  // A Gauss-Newton step for the distances across the curve only, as points may
  // slide along it. Needs few rounds.
  void improve() {
    double m[4][5] = {};
    switch (unknowns_) {
      case 2:
        add_normal_equations<2>(m);
        break;
      case 3:
        add_normal_equations<3>(m);
        break;
      default:
        add_normal_equations<4>(m);
    }
    for (size_t r = 0; r < unknowns_; ++r) {
      m[r][r] += kDamping * static_cast<double>(count_);
    }
    double step[4] = {};
    if (!eliminate(m, unknowns_, step)) {
      return;
    }
    double x[4];
    double share = 1;
    do {
      for (size_t r = 0; r < unknowns_; ++r) {
        x[r] = handle_[r] + share * step[r];
      }
      share /= 2;
    } while (!usable(x) && share > kLeastStep);
    if (usable(x)) {
      set_handles(x);
    }
  }

  // Most of the time of a fit: compilers unroll the loops over unknowns, whose
  // count they know, and keep the sums in registers.
  template <size_t kUnknowns>
  void add_normal_equations(double (&m)[4][5]) const {
    Numbers rows[kUnknowns];
    Numbers off;
    Numbers scale;  // 1 / |normal|^2
    for (size_t i = 0; i < count_; ++i) {
      const double t = t_[i];
      const Point slope = power_.slope(t);
      const Point normal = {-slope.y, slope.x};
      scale[i] = 1 / (dot(normal, normal) + kTiny);
      off[i] = dot(Point{x_[i], y_[i]} - power_.at(t), normal);
      for (size_t r = 0; r < kUnknowns; ++r) {
        rows[r][i] = weight(r, t) * dot(basis_[r], normal);
      }
    }
    double sum[kUnknowns][kUnknowns + 1] = {};
    for (size_t i = 0; i < count_; ++i) {
      for (size_t r = 0; r < kUnknowns; ++r) {
        const double row = scale[i] * rows[r][i];
        for (size_t c = 0; c < kUnknowns; ++c) {
          sum[r][c] += row * rows[c][i];
        }
        sum[r][kUnknowns] += row * off[i];
      }
    }
    for (size_t r = 0; r < kUnknowns; ++r) {
      std::copy(sum[r], sum[r] + kUnknowns, m[r]);
      m[r][4] = sum[r][kUnknowns];
    }
  }

  // The other half of a symmetric matrix.
  static void mirror(double (&m)[4][5]) {
    for (int r = 1; r < 4; ++r) {
      for (int c = 0; c < r; ++c) {
        m[r][c] = m[c][r];
      }
    }
  }

  void set_handles(const double (&x)[4]) {
    cubic_.p[1] = cubic_.p[0];
    cubic_.p[2] = cubic_.p[3];
    for (size_t r = 0; r < unknowns_; ++r) {
      handle_[r] = x[r];
      Point& handle = cubic_.p[second_[r] ? 2 : 1];
      handle = handle + x[r] * basis_[r];
    }
    power_ = PowerForm(cubic_);
  }

  static bool eliminate(double (&m)[4][5], size_t n, double (&x)[4]) {
    for (size_t k = 0; k < n; ++k) {
      size_t best = k;
      for (size_t r = k + 1; r < n; ++r) {
        best = std::fabs(m[r][k]) > std::fabs(m[best][k]) ? r : best;
      }
      if (std::fabs(m[best][k]) < 1e-12) {
        return false;
      }
      std::swap(m[k], m[best]);
      for (size_t r = k + 1; r < n; ++r) {
        const double f = m[r][k] / m[k][k];
        for (size_t c = k; c < 5; ++c) {
          m[r][c] -= f * m[k][c];
        }
      }
    }
    for (size_t k = n; k-- > 0;) {
      x[k] = m[k][4];
      for (size_t c = k + 1; c < n; ++c) {
        x[k] -= m[k][c] * x[c];
      }
      x[k] /= m[k][k];
    }
    return true;
  }

  // Handles must point forwards and be no longer than the curve. Others may fit
  // as well, but overshoot the ends.
  bool usable(const double (&x)[4]) const {
    int i = 0;
    for (const bool is_second : {false, true}) {
      if (is_second ? stretch_.end : stretch_.begin) {
        if (x[i] < 0.02 * length_ || x[i] > length_) {
          return false;
        }
        i += 1;
        continue;
      }
      const Point handle = {x[i], x[i + 1]};
      if (length(handle) > length_ || dot(handle, forwards(is_second)) < 0) {
        return false;
      }
      i += 2;
    }
    return true;
  }

  // The direction of the points at an end.
  Point forwards(bool is_second) const {
    if (count_ == 0) {
      return is_second ? cubic_.p[0] - cubic_.p[3] : cubic_.p[3] - cubic_.p[0];
    }
    const size_t i = is_second ? count_ - 1 : 0;
    return Point{x_[i], y_[i]} - cubic_.p[is_second ? 3 : 0];
  }

  void thirds() {
    const Point straight = unit(cubic_.p[3] - cubic_.p[0]);
    const Point out = stretch_.begin.value_or(straight);
    const Point back = -1.0 * stretch_.end.value_or(straight);
    double x[4];
    for (size_t r = 0; r < unknowns_; ++r) {
      x[r] = length_ / 3 * dot(second_[r] ? back : out, basis_[r]);
    }
    set_handles(x);
  }

  // Moves the parameters. Returns the largest distance.
  double project() {
    Numbers next;
    for (size_t i = 0; i < count_; ++i) {
      const double t = t_[i];
      const Point off = power_.at(t) - Point{x_[i], y_[i]};
      const Point slope = power_.slope(t);
      const double down = dot(slope, slope) + dot(off, power_.bend(t));
      const double step = dot(off, slope) / (std::fabs(down) + kTiny);
      next[i] = t - (down > 0 ? 1.0 : 0.0) * step;
    }
    double least = 0;
    for (size_t i = 0; i < count_; ++i) {
      t_[i] = std::clamp(next[i], least, 1.0);
      least = t_[i];
    }
    double worst = 0;
    for (size_t i = 0; i < count_; ++i) {
      const Point left = power_.at(t_[i]) - Point{x_[i], y_[i]};
      worst = std::max(worst, dot(left, left));
    }
    return std::sqrt(worst);
  }

  // Compares all points with chords of the curve, both in order.
  void measure(FittedCubic& result) const {
    constexpr int kChords = 64;
    Point chord[kChords + 1];
    for (int i = 0; i <= kChords; ++i) {
      chord[i] = cubic_at(cubic_, static_cast<double>(i) / kChords);
    }
    int at = 0;
    const size_t step = 1 + stretch_.count / kMostMeasured;
    for (size_t i = 1; i + 1 < stretch_.count; i += step) {
      const Point& p = stretch_.points[i];
      double best = distance_to_piece(p, chord[at], chord[at + 1]);
      for (int next = at + 1; next < kChords; ++next) {
        const double d = distance_to_piece(p, chord[next], chord[next + 1]);
        if (d > best) {
          break;
        }
        best = d;
        at = next;
      }
      result.worst = std::max(result.worst, best);
    }
  }

  Stretch stretch_;
  double limit_;
  double length_ = 0;
  size_t count_ = 0;  // of points between the ends
  Numbers x_;
  Numbers y_;
  Numbers t_;
  gen::Segment cubic_;
  PowerForm power_;  // of cubic_
  size_t unknowns_ = 0;
  Point basis_[4];
  bool second_[4] = {};    // of the second handle
  double handle_[4] = {};  // the unknowns
};

}  // namespace

FittedCubic fit_cubic(const Stretch& stretch, double limit) {
  return CubicFit(stretch, limit).run();
}

Point cubic_at(const gen::Segment& cubic, double t) {
  const double s = 1 - t;
  const Point* p = cubic.p;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] +
         t * t * t * p[3];
}

Point cubic_slope(const gen::Segment& cubic, double t) {
  const double s = 1 - t;
  const Point* p = cubic.p;
  return 3 * s * s * (p[1] - p[0]) + 6 * s * t * (p[2] - p[1]) +
         3 * t * t * (p[3] - p[2]);
}

}  // namespace inkcell::design
