// Poses of glyphs: offset, angle, scale, slant, weight, opacity; blends of
// poses.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/numbers.hpp"
#include "inkcell/span.hpp"

namespace inkcell::motion {

/// A scale: -8 to 8, resolution 1/4096.
using Scale = Fixed<int16_t, 12>;

/// A change to a glyph that is laid out. The default changes nothing. Scale,
/// slant and angle are applied about the glyph's pivot, in this order.
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

/// a at progress 0, b at 1. Extrapolates; each member is clamped to its range.
/// Angles turn by the smaller angle, counter-clockwise if both are equal.
Pose mix(const Pose& a, const Pose& b, Q16_16 progress) noexcept;

/// Both poses: offsets, angles, slants and weights are summed, scales and
/// opacities multiplied.
Pose combine(const Pose& a, const Pose& b) noexcept;

/// A pose at a time, and the easing to the next.
struct PoseKey {
  int32_t at_ms = 0;
  Pose pose;
  Easing easing;
};

/// The pose at a time; outside of the keys that of the nearest, without keys
/// the default. Times must ascend.
Pose pose_at(Span<const PoseKey> keys, int32_t time_ms) noexcept;

/// The next time >= `time_ms` at which the pose changes; kNever if there is
/// none (timeline.hpp).
int32_t next_due(Span<const PoseKey> keys, int32_t time_ms) noexcept;

/// A glyph to draw: the place of its pivot on the screen, and its pose.
struct PosedGlyph {
  Point at;        // the pivot on the screen, without pose.offset [px, y down]
  Q16_16 pivot_x;  // in the glyph, from its origin [px at scale 1, y up]
  Q16_16 pivot_y;
  uint16_t glyph = 0;
  Pose pose;
};

bool operator==(const PosedGlyph& a, const PosedGlyph& b) noexcept;
inline bool operator!=(const PosedGlyph& a, const PosedGlyph& b) noexcept {
  return !(a == b);
}

}  // namespace inkcell::motion
