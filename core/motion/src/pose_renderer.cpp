// Turns a pose into a matrix, a style and a position.
#include "inkcell/motion/pose_renderer.hpp"

#include "inkcell/motion/fade.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

// A scale of at least 4 px to the em, with its sign.
int32_t wide_enough(int32_t scale_q12, int32_t size_q6) noexcept {
  const int32_t least = ((kMinSize.raw << 12) + size_q6 - 1) / size_q6;
  if (abs(scale_q12) >= least) {
    return scale_q12;
  }
  return scale_q12 < 0 ? -least : least;
}

}  // namespace

// The glyph's axes, as multiples of the size, and its origin.
struct PoseRenderer::Map {
  int32_t x_right_q16;
  int32_t x_up_q16;
  int32_t y_right_q16;
  int32_t y_up_q16;
  Point origin;
  Q26_6 size;  // for uniform scales; else 0
};

bool PoseRenderer::map_of(const PosedGlyph& glyph, Map& out) const noexcept {
  const Pose& pose = glyph.pose;
  const int32_t size_q6 = size_.raw;
  if (pose.opacity == 0 || size_q6 < kMinSize.raw || size_q6 > kMaxSize.raw) {
    return false;
  }
  const int32_t most = max(abs(pose.scale_x.raw), abs(pose.scale_y.raw));
  const int64_t most_q6 = int64_t{size_q6} * most >> 12;
  if (most_q6 < kMinSize.raw || most_q6 > kMaxSize.raw) {
    return false;
  }
  const int32_t x_q12 = wide_enough(pose.scale_x.raw, size_q6);
  const int32_t y_q12 = wide_enough(pose.scale_y.raw, size_q6);
  const int32_t c = cosine(pose.angle).raw;
  const int32_t s = sine(pose.angle).raw;
  const int32_t slant = pose.slant.raw;
  out.x_right_q16 = (x_q12 * c) >> 10;
  out.x_up_q16 = (x_q12 * s) >> 10;
  // At most 3 in Q14 times 8 in Q12.
  out.y_right_q16 =
      static_cast<int32_t>(int64_t{y_q12} * ((slant * c >> 14) - s) >> 10);
  out.y_up_q16 =
      static_cast<int32_t>(int64_t{y_q12} * ((slant * s >> 14) + c) >> 10);
  const bool is_similar = x_q12 == y_q12 && x_q12 > 0 && slant == 0;
  out.size.raw = is_similar ? static_cast<int32_t>(most_q6) : 0;

  const int64_t x = glyph.pivot_x.raw;
  const int64_t y = glyph.pivot_y.raw;
  constexpr int64_t kHalf = 1 << 25;
  const int64_t right_q6 =
      (out.x_right_q16 * x + out.y_right_q16 * y + kHalf) >> 26;
  const int64_t up_q6 = (out.x_up_q16 * x + out.y_up_q16 * y + kHalf) >> 26;
  constexpr int64_t kFarQ6 = int64_t{1} << 22;  // 65536 px
  const int64_t at_x = int64_t{glyph.at.x.raw} + pose.offset.x.raw - right_q6;
  const int64_t at_y = int64_t{glyph.at.y.raw} + pose.offset.y.raw + up_q6;
  if (at_x > kFarQ6 || at_x < -kFarQ6 || at_y > kFarQ6 || at_y < -kFarQ6) {
    return false;
  }
  out.origin = {Q26_6::from_raw(static_cast<int32_t>(at_x)),
                Q26_6::from_raw(static_cast<int32_t>(at_y))};
  return true;
}

Rect PoseRenderer::box_of(const PosedGlyph& glyph,
                          const Map& map) const noexcept {
  const InkBox ink = font_.ink_box(glyph.glyph);
  if (ink.x1_u <= ink.x0_u || ink.y1_u <= ink.y0_u) {
    return {};
  }
  // Scaled sizes are below 2^10 px, slanted ones 3 times that, boxes 2^14 u.
  // [px, Q4] The floor is a pixel lower, for what is cut off.
  const auto px_q4 = [&](int32_t entry_q16) {
    return static_cast<int32_t>(int64_t{entry_q16} * size_.raw >> 18);
  };
  const int32_t axes_q4[] = {px_q4(map.x_right_q16), px_q4(map.y_right_q16),
                             px_q4(-map.x_up_q16), px_q4(-map.y_up_q16)};
  // The reach of the filter.
  const int32_t reach_q10 = glyph.pose.weight.raw - filter_.outside_q10;
  const int32_t reach_q4 = (reach_q10 > 0 ? reach_q10 >> 6 : 0) + 2 * 16;
  const int32_t origin_q4[] = {map.origin.x.raw >> 2, map.origin.y.raw >> 2};
  int32_t low[2];
  int32_t high[2];
  for (int side = 0; side < 2; ++side) {
    // Each axis has its minimum at one end of the box and its maximum at the
    // other.
    const int32_t x = axes_q4[2 * side];
    const int32_t y = axes_q4[2 * side + 1];
    const int32_t x_low = x * (x < 0 ? ink.x1_u : ink.x0_u);
    const int32_t x_high = x * (x < 0 ? ink.x0_u : ink.x1_u);
    const int32_t y_low = y * (y < 0 ? ink.y1_u : ink.y0_u);
    const int32_t y_high = y * (y < 0 ? ink.y0_u : ink.y1_u);
    const int32_t least = (x_low >> 10) + (y_low >> 10);
    const int32_t most = (x_high >> 10) + (y_high >> 10);
    low[side] = (origin_q4[side] + least - reach_q4) >> 4;
    high[side] = ((origin_q4[side] + most + reach_q4) >> 4) + 1;
  }
  return {low[0], low[1], high[0], high[1]};
}

bool PoseRenderer::make_style(const PosedGlyph& glyph,
                              const Map& map) noexcept {
  const Pose& pose = glyph.pose;
  const Filter* filter = &filter_;
  if (pose.weight.raw != 0) {
    // As with_weight(), without its 268 bytes of stack.
    weighted_ = filter_;
    weighted_.add_weight(pose.weight);
    filter = &weighted_;
  }
  if (map.size.raw != 0) {
    style_ = pose.angle.raw == 0
                 ? Style(map.size, *filter)
                 : Style(map.size, *filter, direction_of(pose.angle));
    return true;
  }
  const auto px = [&](int32_t entry_q16) {
    const int64_t px_q16 = int64_t{entry_q16} * size_.raw >> 6;
    // Values beyond 2^31 exceed the largest size.
    return Q16_16::from_raw(clamp_i64(px_q16, INT32_MIN + 1, INT32_MAX));
  };
  const Matrix matrix = {px(map.x_right_q16), px(map.x_up_q16),
                         px(map.y_right_q16), px(map.y_up_q16)};
  if (!stretch_of(matrix).is_in_range()) {
    return false;
  }
  style_ = Style(matrix, *filter);
  return true;
}

void PoseRenderer::draw(Span<const PosedGlyph> glyphs,
                        const Painter& painter) noexcept {
  for (const PosedGlyph& glyph : glyphs) {
    Map map;
    if (!map_of(glyph, map) ||
        is_empty(intersect(box_of(glyph, map), painter.sink().window)) ||
        !make_style(glyph, map)) {
      continue;
    }
    const Fade fade = {&painter.sink(), glyph.pose.opacity};
    const Sink sink = make_sink(fade);
    painter.with(sink).for_motion().glyph(font_, style_, map.origin,
                                          glyph.glyph);
  }
}

void PoseRenderer::draw(const PosedGlyph& glyph,
                        const OutlineMorph& morph,
                        Q16_16 progress,
                        const Painter& painter) noexcept {
  Map map;
  if (map_of(glyph, map) && make_style(glyph, map)) {
    const Fade fade = {&painter.sink(), glyph.pose.opacity};
    const Sink sink = make_sink(fade);
    morph.draw(painter.with(sink).for_motion(), style_, map.origin, progress);
  }
}

Rect PoseRenderer::box(const PosedGlyph& glyph) const noexcept {
  Map map;
  return map_of(glyph, map) ? box_of(glyph, map) : Rect();
}

Rect PoseRenderer::box(const PosedGlyph& glyph,
                       const OutlineMorph& morph,
                       Q16_16 progress) noexcept {
  Map map;
  return map_of(glyph, map) && make_style(glyph, map)
             ? morph.box(style_, map.origin, progress)
             : Rect();
}

void PoseRenderer::add_changes(Span<const PosedGlyph> before,
                               Span<const PosedGlyph> now,
                               const Rect& screen,
                               DirtyRects& dirty) const noexcept {
  const size_t count = before.size > now.size ? before.size : now.size;
  for (size_t i = 0; i < count; ++i) {
    if (i < before.size && i < now.size && before[i] == now[i]) {
      continue;
    }
    // The old and the new box usually overlap: add them as one.
    const Rect left = i < before.size ? box(before[i]) : Rect();
    const Rect entered = i < now.size ? box(now[i]) : Rect();
    if (is_empty(intersect(left, entered))) {
      dirty.add(left, screen);
      dirty.add(entered, screen);
    } else {
      dirty.add(bounding_box(left, entered), screen);
    }
  }
}

}  // namespace inkcell::motion
