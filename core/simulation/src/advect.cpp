// Semi-Lagrangian advection.
//
// All steps round to nearest: truncation would add a constant drift.
#include "inkcell/simulation/advect.hpp"

#include "base/known_span.hpp"
#include "base/math.hpp"
#include "inkcell/motion/numbers.hpp"
#include "limits.hpp"

namespace inkcell::simulation {
namespace {

constexpr int32_t kMostStrength = 1 << 26;

// Weights of the Catmull-Rom cubic through four samples, between the second and
// the third. [Q12] Their sum is 1.
struct Weights {
  int32_t of[4];

  // `t` is Q8, 0 to 255.
  explicit Weights(int32_t t) noexcept {
    const int32_t once = t << 4;
    const int32_t square = (t * t + 8) >> 4;
    const int32_t cube = (t * t * t + (1 << 11)) >> 12;
    of[1] = (2 * 4096 - 5 * square + 3 * cube) >> 1;
    of[2] = (once + 4 * square - 3 * cube) >> 1;
    of[3] = (cube - square) >> 1;
    of[0] = 4096 - of[1] - of[2] - of[3];
  }

  int32_t sum(int32_t a, int32_t b, int32_t c, int32_t d) const noexcept {
    return a * of[0] + b * of[1] + c * of[2] + d * of[3];
  }
};

// To the nearest 1/256.
int32_t rounded(Q16_16 value) noexcept {
  return (value.raw >> 8) + ((value.raw >> 7) & 1);
}

// From a sample to the place where it was a step ago. [samples, Q8]
struct Offset {
  int32_t x;
  int32_t y;
};

// Q20 to Q8.
int32_t nearest(int32_t value) noexcept {
  return (value + 2048) >> 12;
}

// A flow whose numbers are in range.
class Motion {
 public:
  explicit Motion(const Flow& flow) noexcept
      : drift_{-clamp(rounded(flow.x_drift), -kFar, kFar),
               -clamp(rounded(flow.y_drift), -kFar, kFar)},
        fastest_(max(abs(drift_.x), abs(drift_.y))) {
    for (const Vortex& vortex : flow.vortices) {
      if (end_ == whirls_ + Flow::kMaxVortices) {
        break;
      }
      const int32_t core = clamp(vortex.core, 1, 255);
      const int32_t strength =
          clamp(vortex.strength, -kMostStrength, kMostStrength);
      *end_++ = {clamp(vortex.x.raw >> 8, -(1 << 17), 1 << 17),
                 clamp(vortex.y.raw >> 8, -(1 << 17), 1 << 17), core * core,
                 strength * 16};
      // The speed is greatest at the radius of the core.
      fastest_ += abs(strength) / (2 * core) + 8;
    }
  }

  // A sample that moves less than one sample and is far from edges, with all
  // its neighbours, stays far.
  bool is_slow() const noexcept { return fastest_ < 256; }

  Offset look_back(int32_t x, int32_t y) const noexcept {
    Offset offset = drift_;
    for (const Whirl* whirl = whirls_; whirl != end_; ++whirl) {
      whirl->add(x * 256 + 128, y * 256 + 128, offset);
    }
    return {clamp(offset.x, -kFar, kFar), clamp(offset.y, -kFar, kFar)};
  }

 private:
  static constexpr int32_t kFar = 16 << 8;

  // A vortex.
  struct Whirl {
    int32_t x_q8;  // at most 2^17
    int32_t y_q8;
    int32_t core_square;   // at least 1
    int32_t strength_q12;  // [samples^2 a step]

    void add(int32_t at_x_q8, int32_t at_y_q8, Offset& offset) const noexcept {
      // At most 2^18 + 2^17 each.
      const int32_t right = at_x_q8 - x_q8;
      const int32_t down = at_y_q8 - y_q8;
      const int32_t right_q2 = right >> 6;
      const int32_t down_q2 = down >> 6;
      const int32_t square =
          ((right_q2 * right_q2 + down_q2 * down_q2) >> 4) + core_square;
      // The angle of a step, at most 1/2. [radians, Q12]
      const int32_t turn_q12 = clamp(strength_q12 / square, -2048, 2048);
      // Rotation back by the angle a, y down: (x cos a - y sin a, ...).
      const int32_t half_square_q12 = turn_q12 * turn_q12 >> 13;
      const int32_t near_right = clamp(right, -(1 << 16), 1 << 16);
      const int32_t near_down = clamp(down, -(1 << 16), 1 << 16);
      offset.x -= nearest(near_down * turn_q12 + near_right * half_square_q12);
      offset.y += nearest(near_right * turn_q12 - near_down * half_square_q12);
    }
  };

  Offset drift_;
  int32_t fastest_;  // an upper bound of the step along an axis [samples, Q8]
  Whirl whirls_[Flow::kMaxVortices];
  Whirl* end_ = whirls_;
};

// The value between the sample `at` and the next one, from the 16 around it.
// [1/32 of a sample's side]
int8_t cubic_at(const int8_t* at,
                int32_t stride,
                int32_t right,
                int32_t down) noexcept {
  const Weights across(right);
  int32_t rows[4];  // [Q12]
  at -= stride + 1;
  for (int32_t& row : rows) {
    row = across.sum(at[0], at[1], at[2], at[3]);
    at += stride;
  }
  // Below 2^20: in Q8, so that 32 bits hold the second product.
  const int32_t sum = Weights(down).sum((rows[0] + 8) >> 4, (rows[1] + 8) >> 4,
                                        (rows[2] + 8) >> 4, (rows[3] + 8) >> 4);
  return static_cast<int8_t>(
      clamp((sum + (1 << 19)) >> 20, INT8_MIN, INT8_MAX));
}

// The side of a sample so far from edges that it need not be exact, or 0.
int32_t far_side(int32_t value) noexcept {
  constexpr int32_t kFar = 120;
  return value >= kFar ? 1 : value <= -kFar ? -1 : 0;
}

// The same for three samples in a column; 0 also if they differ.
int32_t far_side(const int8_t* above,
                 const int8_t* at,
                 const int8_t* below) noexcept {
  const int32_t side = far_side(*at);
  return side != 0 && far_side(*above) == side && far_side(*below) == side
             ? side
             : 0;
}

// The value at a place of the grid. [samples from the first one's middle, Q8]
int8_t value_at(const DistanceGrid& grid, int32_t x_q8, int32_t y_q8) noexcept {
  const int32_t left = x_q8 >> 8;
  const int32_t top = y_q8 >> 8;
  const bool is_inside = left >= 1 && top >= 1 && left + 2 < grid.width() &&
                         top + 2 < grid.height();
  if (!is_inside) {
    int8_t around[16];
    for (int32_t i = 0; i < 16; ++i) {
      around[i] = grid.at(left - 1 + (i & 3), top - 1 + (i >> 2));
    }
    return cubic_at(around + 5, 4, x_q8 & 255, y_q8 & 255);
  }
  const int8_t* at = grid.row(top) + left;
  const int32_t stride = grid.width();
  const int32_t side = far_side(at[0]);
  if (side != 0 && far_side(at[1]) == side && far_side(at[stride]) == side &&
      far_side(at[stride + 1]) == side) {
    const int32_t right = (x_q8 & 255) >= 128 ? 1 : 0;
    return at[right + ((y_q8 & 255) >= 128 ? stride : 0)];
  }
  return cubic_at(at, stride, x_q8 & 255, y_q8 & 255);
}

// The new value of a sample.
int8_t moved(const DistanceGrid& grid,
             const Motion& motion,
             int32_t x,
             int32_t y) noexcept {
  const Offset offset = motion.look_back(x, y);
  return value_at(grid, x * 256 + offset.x, y * 256 + offset.y);
}

// The same from the four samples around it: of a shape that is looked up once,
// the eye sees no difference.
int8_t linear_at(const DistanceGrid& grid,
                 int32_t x_q8,
                 int32_t y_q8) noexcept {
  const int32_t left = x_q8 >> 8;
  const int32_t top = y_q8 >> 8;
  if (left < -1 || top < -1 || left >= grid.width() || top >= grid.height()) {
    return DistanceGrid::kOutside;
  }
  int8_t around[4];
  const int8_t* at = around;
  int32_t stride = 2;
  if (left >= 0 && top >= 0 && left + 1 < grid.width() &&
      top + 1 < grid.height()) {
    at = grid.row(top) + left;
    stride = grid.width();
  } else {
    for (int32_t i = 0; i < 4; ++i) {
      around[i] = grid.at(left + (i & 1), top + (i >> 1));
    }
  }
  const int32_t right = x_q8 & 255;
  const int32_t down = y_q8 & 255;
  const int32_t above = at[0] * 256 + (at[1] - at[0]) * right;
  const int32_t below =
      at[stride] * 256 + (at[stride + 1] - at[stride]) * right;
  return static_cast<int8_t>(
      (above * 256 + (below - above) * down + (1 << 15)) >> 16);
}

// A vortex whose numbers are in range, for any time.
class Winding {
 public:
  explicit Winding(const Vortex& vortex) noexcept
      : x_q8_(clamp(vortex.x.raw >> 8, -kFar, kFar)),
        y_q8_(clamp(vortex.y.raw >> 8, -kFar, kFar)),
        core_square_q4_(clamp(vortex.core, 1, 255) *
                        clamp(vortex.core, 1, 255) * 16) {
    const int32_t strength =
        clamp(vortex.strength, -kMostStrength, kMostStrength);
    rough_ = abs(strength) < 1 << 22 ? 0 : 4;
    strength_ = strength * (256 >> rough_);
  }

  // Of a sample's middle from the centre. [samples^2, Q4]
  int32_t square_q4(int32_t x, int32_t y) const noexcept {
    const int32_t right_q2 = (x * 256 + 128 - x_q8_) >> 6;
    const int32_t down_q2 = (y * 256 + 128 - y_q8_) >> 6;
    return right_q2 * right_q2 + down_q2 * down_q2;
  }

  // The samples of a row that are at most this far from the centre.
  detail::KnownSpan within(int32_t most_square_q4,
                           int32_t y,
                           int32_t width) const noexcept {
    const int32_t down_q2 = (y * 256 + 128 - y_q8_) >> 6;
    const int32_t rest = most_square_q4 - down_q2 * down_q2;
    if (rest < 0) {
      return {width, 0};
    }
    const auto half_q2 =
        static_cast<int32_t>(detail::root_of(static_cast<uint32_t>(rest)));
    return {clamp(((x_q8_ >> 6) - half_q2) >> 2, 0, width),
            clamp((((x_q8_ >> 6) + half_q2) >> 2) + 1, 0, width)};
  }

  // The value that a sample has now. The corner is that of the grid. [Q8]
  int8_t value_of(const DistanceGrid& grid,
                  const Offset& corner,
                  int32_t x,
                  int32_t y) const noexcept {
    const int32_t right = clamp(x * 256 + 128 - x_q8_, -kMost, kMost);
    const int32_t down = clamp(y * 256 + 128 - y_q8_, -kMost, kMost);
    const int32_t turn_q12 =
        clamp(strength_ / ((square_q4(x, y) + core_square_q4_) >> rough_),
              -kTurn, kTurn);
    // From radians to parts of a turn.
    const auto turn = motion::Angle::from_raw(
        static_cast<uint16_t>((turn_q12 * 10430 + 2048) >> 12));
    const int32_t sine_q12 = (motion::sine(turn).raw + 2) >> 2;
    const int32_t cosine_q12 = (motion::cosine(turn).raw + 2) >> 2;
    // Rotation back, as in Whirl.
    return linear_at(
        grid, x_q8_ - corner.x + nearest(right * cosine_q12 - down * sine_q12),
        y_q8_ - corner.y + nearest(right * sine_q12 + down * cosine_q12));
  }

 private:
  static constexpr int32_t kFar = 1 << 17;
  // Samples are this near to a centre in the grid. [Q8]
  static constexpr int32_t kMost = 1 << 18;
  static constexpr int32_t kTurn = 1 << 17;  // [radians, Q12]

  int32_t x_q8_;
  int32_t y_q8_;
  int32_t core_square_q4_;
  int32_t rough_;     // bits that are left off to divide a great strength
  int32_t strength_;  // [samples^2 rad, Q16 less those bits]
};

}  // namespace

void advect(const DistanceGrid& grid,
            const Flow& flow,
            DistanceGrid& out) noexcept {
  if (grid.width() != out.width() || grid.height() != out.height() ||
      grid.width() == 0) {
    return;
  }
  const Motion motion(flow);
  const bool is_slow = motion.is_slow();
  const detail::KnownSpan all = {0, grid.width()};
  const detail::KnownSpan none = {grid.width(), 0};
  detail::KnownSpan known_above = none;
  detail::KnownSpan known = detail::known_span(grid.row(0), grid.width());
  for (int32_t y = 0; y < grid.height(); ++y) {
    int8_t* to = out.row(y);
    const int8_t* at = grid.row(y);
    const bool is_border = y == 0 || y + 1 == grid.height();
    const int8_t* above = is_border ? at : at - grid.width();
    const int8_t* below = is_border ? at : at + grid.width();
    const detail::KnownSpan known_below =
        y + 1 == grid.height()
            ? none
            : detail::known_span(grid.row(y + 1), grid.width());
    detail::KnownSpan span = united(known, united(known_above, known_below));
    span = is_slow ? grown(span, 1, grid.width()) : all;
    known_above = known;
    known = known_below;
    detail::clear_around(span, to, grid.width());
    int32_t before = 0;  // sides of the previous column, and of this one
    int32_t here = 0;
    for (int32_t x = span.first; x < span.end; ++x) {
      const int32_t after =
          is_slow && !is_border && x + 1 < grid.width()
              ? far_side(above + x + 1, at + x + 1, below + x + 1)
              : 0;
      to[x] = here != 0 && before == here && after == here
                  ? at[x]
                  : moved(grid, motion, x, y);
      before = here;
      here = after;
    }
  }
}

void wind(const DistanceGrid& grid,
          int32_t left,
          int32_t top,
          const Vortex& vortex,
          DistanceGrid& out) noexcept {
  constexpr int32_t kMostAway = 4096;
  left = clamp(left, -kMostAway, kMostAway);
  top = clamp(top, -kMostAway, kMostAway);
  const Offset corner = {left * 256 + 128, top * 256 + 128};
  const Winding winding(vortex);
  // The shape stays in a circle around the centre.
  int32_t farthest = 0;
  for (int32_t y = 0; y < grid.height(); ++y) {
    const detail::KnownSpan known =
        detail::known_span(grid.row(y), grid.width());
    if (known.first < known.end) {
      farthest =
          max(farthest, max(winding.square_q4(left + known.first - 2, top + y),
                            winding.square_q4(left + known.end + 1, top + y)));
    }
  }
  for (int32_t y = 0; y < out.height(); ++y) {
    const detail::KnownSpan span = winding.within(farthest, y, out.width());
    int8_t* to = out.row(y);
    detail::clear_around(span, to, out.width());
    for (int32_t x = span.first; x < span.end; ++x) {
      to[x] = winding.value_of(grid, corner, x, y);
    }
  }
}

}  // namespace inkcell::simulation
