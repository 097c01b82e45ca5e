// Blends and combines poses.
#include "inkcell/motion/pose.hpp"

#include "keys.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

int16_t clamp_q(int64_t value) noexcept {
  return static_cast<int16_t>(clamp_i64(value, INT16_MIN, INT16_MAX));
}

int16_t mix_q(int16_t a, int16_t b, Q16_16 progress) noexcept {
  return clamp_q(lerp(a, b, progress));
}

Scale times(Scale a, Scale b) noexcept {
  return Scale::from_raw(clamp_q((a.raw * b.raw + (1 << 11)) >> 12));
}

Q26_6 sum(Q26_6 a, Q26_6 b) noexcept {
  return Q26_6::from_raw(
      clamp_i64(int64_t{a.raw} + b.raw, INT32_MIN, INT32_MAX));
}

}  // namespace

bool operator==(const Pose& a, const Pose& b) noexcept {
  return a.offset.x == b.offset.x && a.offset.y == b.offset.y &&
         a.angle == b.angle && a.scale_x == b.scale_x &&
         a.scale_y == b.scale_y && a.slant == b.slant && a.weight == b.weight &&
         a.opacity == b.opacity;
}

bool operator==(const PosedGlyph& a, const PosedGlyph& b) noexcept {
  return a.glyph == b.glyph && a.at.x == b.at.x && a.at.y == b.at.y &&
         a.pivot_x == b.pivot_x && a.pivot_y == b.pivot_y && a.pose == b.pose;
}

Pose mix(const Pose& a, const Pose& b, Q16_16 progress) noexcept {
  Pose pose;
  pose.offset.x.raw = lerp(a.offset.x.raw, b.offset.x.raw, progress);
  pose.offset.y.raw = lerp(a.offset.y.raw, b.offset.y.raw, progress);
  const auto difference = static_cast<int16_t>(b.angle.raw - a.angle.raw);
  const int32_t turn = difference == INT16_MIN ? -difference : difference;
  pose.angle.raw = static_cast<uint16_t>(a.angle.raw + lerp(0, turn, progress));
  pose.scale_x.raw = mix_q(a.scale_x.raw, b.scale_x.raw, progress);
  pose.scale_y.raw = mix_q(a.scale_y.raw, b.scale_y.raw, progress);
  pose.slant.raw = mix_q(a.slant.raw, b.slant.raw, progress);
  pose.weight.raw = mix_q(a.weight.raw, b.weight.raw, progress);
  pose.opacity =
      static_cast<uint8_t>(clamp(lerp(a.opacity, b.opacity, progress), 0, 255));
  return pose;
}

Pose combine(const Pose& a, const Pose& b) noexcept {
  Pose pose;
  pose.offset = {sum(a.offset.x, b.offset.x), sum(a.offset.y, b.offset.y)};
  pose.angle.raw = static_cast<uint16_t>(a.angle.raw + b.angle.raw);
  pose.scale_x = times(a.scale_x, b.scale_x);
  pose.scale_y = times(a.scale_y, b.scale_y);
  pose.slant.raw = clamp_q(a.slant.raw + b.slant.raw);
  pose.weight.raw = clamp_q(a.weight.raw + b.weight.raw);
  pose.opacity = static_cast<uint8_t>((a.opacity * b.opacity + 127) / 255);
  return pose;
}

Pose pose_at(Span<const PoseKey> keys, int32_t time_ms) noexcept {
  if (keys.size == 0) {
    return {};
  }
  const Segment<PoseKey> at = segment_at(keys, time_ms);
  return mix(at.from.pose, at.to.pose, at.progress);
}

int32_t next_due(Span<const PoseKey> keys, int32_t time_ms) noexcept {
  return next_change(keys, &PoseKey::pose, time_ms);
}

}  // namespace inkcell::motion
