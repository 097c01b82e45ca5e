// How a glyph stands: place, angle, scale, slant, weight, opacity; and between.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/kinetic/easing.hpp"
#include "inkcell/kinetic/numbers.hpp"
#include "inkcell/span.hpp"

namespace inkcell {
namespace kinetic {

/// A scale: -8 to 8, resolution 1/4096.
using Scale = Fixed<int16_t, 12>;

/// What is done to a glyph that layout has placed. The default leaves it as it
/// is. Scale, slant and angle work about the glyph's pivot, in this order.
struct Pose {
  Point offset;  // [px, y down]
  Angle angle;
  Scale scale_x = Scale::from_int(1);
  Scale scale_y = Scale::from_int(1);
  Q2_14 slant;   // how far the top leans to the right, over the height
  Q6_10 weight;  // edges move outwards [px]
  uint8_t opacity = 255;
};

bool operator==(const Pose& a, const Pose& b) noexcept;
inline bool operator!=(const Pose& a, const Pose& b) noexcept {
  return !(a == b);
}

/// a at 0, b at 1. Overshoots; what leaves its range is clamped. Angles go the
/// shorter way; of two that are half a turn apart counter-clockwise.
Pose mix(const Pose& a, const Pose& b, Q16_16 progress) noexcept;

/// One on top of the other: offsets, angles, slants and weights are summed,
/// scales and opacities multiplied.
Pose combine(const Pose& a, const Pose& b) noexcept;

/// A pose at a time, and how it goes on to the next.
struct PoseKey {
  int32_t at_ms = 0;
  Pose pose;
  Easing easing;
};

/// The pose of keys at a time: the first before them, the last after them, the
/// default if there are none. Their times must ascend.
Pose pose_at(Span<const PoseKey> keys, int32_t time_ms) noexcept;

/// The next time, `time_ms` or later, at which the pose changes; kNever after
/// that (timeline.hpp).
int32_t next_due(Span<const PoseKey> keys, int32_t time_ms) noexcept;

/// A glyph ready to be drawn: where its pivot is on the screen, and its pose.
struct PosedGlyph {
  Point at;        // on the screen, without the pose's offset [px, y down]
  Q16_16 pivot_x;  // in the glyph, from its origin [px at scale 1, y up]
  Q16_16 pivot_y;
  uint16_t glyph = 0;
  Pose pose;
};

bool operator==(const PosedGlyph& a, const PosedGlyph& b) noexcept;
inline bool operator!=(const PosedGlyph& a, const PosedGlyph& b) noexcept {
  return !(a == b);
}

}  // namespace kinetic
}  // namespace inkcell
