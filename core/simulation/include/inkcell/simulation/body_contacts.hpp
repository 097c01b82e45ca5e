// Contacts and distances between bodies, for step().
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/simulation/bodies.hpp"
#include "inkcell/span.hpp"

namespace inkcell::simulation {

/// Bodies nearer than this touch. [px, Q10]
inline constexpr int32_t kTouchQ10 = 256;

/// Bodies that touch slide this far before their contacts are found again; ones
/// that may overlap more slide farther. [px, Q10]
inline int32_t slide_q10(int32_t overlap_q10) noexcept {
  return 512 + overlap_q10 / 4;
}

/// The gap between rigid bodies: grids round corners off by as much. [px, Q10]
inline constexpr int32_t kSkinQ10 = 160;

/// Farther than any body moves in a piece of a step. [px, Q10]
inline constexpr int32_t kFarQ10 = 64 << 10;

/// The rings around contacts in which bodies bulge are as wide as the range of
/// a grid. The share of a bulge at a distance inside of the other body: 1 where
/// the two meet, 0 at the outer end, and flat at both. [Q10]
inline int32_t bulge_share(int32_t distance_q10, int32_t scale_log2) noexcept {
  const int32_t out = -distance_q10 >> (2 + scale_log2);
  if (out <= 0) {
    return 1024;
  }
  if (out >= 1024) {
    return 0;
  }
  const int32_t in = 1024 - out;
  return (in * in >> 10) * (1024 + 2 * out) >> 10;
}

/// The greatest bulge: at a third of the ring its slope is below 1/2, so that
/// no piece comes off. [px, Q10]
inline int32_t most_bulge_q10(int32_t scale_log2) noexcept {
  return 1360 << (scale_log2 < 1 ? 0 : 1);
}

/// Distances of a shape, as probe() without slopes: what lookups share, so that
/// loops keep it in registers.
class ShapeField {
 public:
  explicit ShapeField(const BodyShape& shape) noexcept
      : samples_(shape.grid().row(0)),
        width_(shape.grid().width()),
        shift_(16 + shape.grid().scale_log2()),
        x_end_((shape.grid().width() - 1) << shift_),
        y_end_((shape.grid().height() - 1) << shift_),
        margin_q10_(shape.margin_q10()) {}

  /// The distance at a place from the centre of the grid's first sample [px,
  /// Q16]; beyond the outermost centres an upper bound. [px, Q10]
  int32_t at(int32_t x, int32_t y) const noexcept {
    if (static_cast<uint32_t>(x) >= static_cast<uint32_t>(x_end_) ||
        static_cast<uint32_t>(y) >= static_cast<uint32_t>(y_end_)) {
      const int32_t across = x - x_end_ > -x ? x - x_end_ : -x;
      const int32_t down = y - y_end_ > -y ? y - y_end_ : -y;
      return -((across > down ? across : down) >> 6) - margin_q10_;
    }
    const int8_t* top = samples_ + (y >> shift_) * width_ + (x >> shift_);
    const int8_t* bottom = top + width_;
    const int32_t x_part = (x >> (shift_ - 8)) & 255;
    const int32_t y_part = (y >> (shift_ - 8)) & 255;
    const int32_t above = top[0] * 256 + (top[1] - top[0]) * x_part;
    const int32_t under = bottom[0] * 256 + (bottom[1] - bottom[0]) * x_part;
    // A sample stands for the middle of its quantum. [Q13 of a sample]
    const int32_t sum = above + ((under - above) * y_part >> 8) + 128;
    return sum * (1 << (shift_ - 16)) >> 3;
  }

 private:
  const int8_t* samples_;
  int32_t width_;
  int32_t shift_;
  int32_t x_end_;
  int32_t y_end_;
  int32_t margin_q10_;
};

/// Shifts a product right and rounds to nearest; the result fits 32 bits.
inline int32_t scaled(int64_t value, uint32_t shift) noexcept {
  return static_cast<int32_t>((value + (int64_t{1} << (shift - 1))) >> shift);
}

/// A rotation, counter-clockwise on the screen. [Q14]
struct Turn {
  int32_t cosine;
  int32_t sine;
};

/// The rotation by an angle.
inline Turn turn_of(motion::Angle angle) noexcept {
  return {motion::cosine(angle).raw, motion::sine(angle).raw};
}

/// An upper bound of the speed of a body's points. [px a step, Q16]
int32_t speed_of(const Body& body) noexcept;

/// An upper bound of the speed of two bodies' points against each other. [px a
/// step, Q16]
int32_t speed_between(const Body& a, const Body& b) noexcept;

/// Finds contacts, wakes sleepers that are hit, and returns the number of
/// contacts. Sets most_speed_q16 and clear_q10 of each body; clear_q10 is the
/// distance to the nearest wall and the nearest body that it does not touch.
/// Sets the members of contacts but those that the solver sets.
size_t find_contacts(Span<Body> bodies,
                     const BodyRules& rules,
                     int32_t still_q16,
                     Span<BodyContact> contacts) noexcept;

/// Sets touches of each body that moves, and of its neighbours.
void find_touches(Span<Body> bodies, const BodyRules& rules) noexcept;

}  // namespace inkcell::simulation
