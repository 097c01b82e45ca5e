// Where pixels lie in a glyph.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "inkcell/render.hpp"
#include "inkcell/text_style.hpp"
#include "raster/field_draw.hpp"

namespace inkcell {
namespace detail {

inline int64_t clamp(int64_t value, int64_t low, int64_t high) noexcept {
  if (value < low) {
    return low;
  }
  return value > high ? high : value;
}

inline int32_t clamp_i32(int64_t value) noexcept {
  return static_cast<int32_t>(clamp(value, INT32_MIN, INT32_MAX));
}

// Where a glyph stands: an origin that is near enough to show something.
// Windows lie within 2^15 px, and no glyph reaches farther than 2^16 px. [Q10]
struct Placed {
  static constexpr int32_t kLimit = 1 << 30;

  int32_t x_q10;
  int32_t y_q10;

  FinePoint origin() const noexcept { return {x_q10, y_q10}; }

  // False: the origin is too far.
  bool set(const FinePoint& at) noexcept {
    x_q10 = static_cast<int32_t>(at.x_q10);
    y_q10 = static_cast<int32_t>(at.y_q10);
    constexpr uint64_t kAll = uint64_t{2} * kLimit;
    return static_cast<uint64_t>(at.x_q10) + kLimit < kAll &&
           static_cast<uint64_t>(at.y_q10) + kLimit < kAll;
  }
  // The same without 64 bits.
  bool set(Point at) noexcept {
    const auto x_q6 = static_cast<uint32_t>(at.x.raw);
    const auto y_q6 = static_cast<uint32_t>(at.y.raw);
    x_q10 = wrapped(x_q6 * 16);
    y_q10 = wrapped(y_q6 * 16);
    constexpr uint32_t kLimitQ6 = kLimit / 16;
    return x_q6 + kLimitQ6 < 2 * kLimitQ6 && y_q6 + kLimitQ6 < 2 * kLimitQ6;
  }
};

// field_box of what is placed.
Rect box_of(const GlyphField& field,
            const TextStyle& style,
            const Placed& placed) noexcept;

// How far one pixel to the right leads in px along the glyph's axes. [Q20]
inline int32_t along_q20(const TextStyle& style) noexcept {
  return style.right().x_q20;
}
inline int32_t across_q20(const TextStyle& style) noexcept {
  return style.up().x_q20;
}

// The pixel's centre from the origin, in px. [Q10]
struct ScreenWay {
  int64_t right_q10;
  int64_t up_q10;

  // Far from anything to see it is clamped, to stay within 64 bits once
  // multiplied.
  ScreenWay(const FinePoint& origin, int32_t x, int32_t y) noexcept
      : right_q10(clamp(int64_t{x} * 1024 + 512 - origin.x_q10, -kFar, kFar)),
        up_q10(clamp(origin.y_q10 - (int64_t{y} * 1024 + 512), -kFar, kFar)) {}
  // The same of a pixel of a window.
  ScreenWay(const Placed& placed, int32_t x, int32_t y) noexcept
      : right_q10(x * 1024 + 512 - placed.x_q10),
        up_q10(placed.y_q10 - (y * 1024 + 512)) {}

 private:
  static constexpr int64_t kFar = int64_t{1} << 37;
};

// The same in the glyph: in u, and in px of the style's size modulo 2^12.
struct GlyphWay {
  int64_t x_q16;
  int64_t y_q16;
  uint32_t x_q20;
  uint32_t y_q20;

  GlyphWay(const TextStyle& style, const ScreenWay& way) noexcept {
    const GlyphStep& right = style.right();
    const GlyphStep& up = style.up();
    x_q16 = sum(way, right.x_q16, up.x_q16);
    y_q16 = sum(way, right.y_q16, up.y_q16);
    x_q20 = static_cast<uint32_t>(sum(way, right.x_q20, up.x_q20)) + kHalfQ20;
    y_q20 = static_cast<uint32_t>(sum(way, right.y_q20, up.y_q20)) + kHalfQ20;
  }

 private:
  // Modulo 2^54: sums of px may wrap. Not inline: products of 64 bits are
  // large.
  __attribute__((noinline)) static int64_t sum(const ScreenWay& way,
                                               int32_t right,
                                               int32_t up) noexcept {
    const uint64_t products =
        static_cast<uint64_t>(way.right_q10) * static_cast<uint64_t>(right) +
        static_cast<uint64_t>(way.up_q10) * static_cast<uint64_t>(up);
    return static_cast<int64_t>(products) >> 10;
  }
};

// Where the centre of pixel (x, y) lies in the glyph.
//
// Linear in x and y with whole steps: neighbours differ by exactly the style's
// step, so that it does not matter where a row or a strip begins. Within the
// box of a field positions in u stay below 2^31: its grid ends at 15360 u,
// twice that in a corner of the box around a turned grid. Around a stretched
// one they may pass it, and are clamped where nothing is.
inline FieldPosition position_of(const TextStyle& style,
                                 const FinePoint& origin,
                                 int32_t x,
                                 int32_t y) noexcept {
  const ScreenWay way(origin, x, y);
  if (style.is_upright()) {
    const int64_t along = style.step_along_q16();
    constexpr int64_t kHalf = kHalfQ20;
    return {clamp_i32((way.right_q10 * along) >> 10),
            clamp_i32((way.up_q10 * along) >> 10),
            static_cast<uint32_t>(way.right_q10 * 1024 + kHalf),
            static_cast<uint32_t>(way.up_q10 * 1024 + kHalf)};
  }
  const GlyphWay at(style, way);
  return {clamp_i32(at.x_q16), clamp_i32(at.y_q16), at.x_q20, at.y_q20};
}

// What may show something: the grid, but no farther from the ink than the
// filter reaches. Painters may show all of the ink, also where the filter's
// ramp begins inside. [u]
inline Rect limits_of(const GlyphField& field,
                      const TextStyle& style) noexcept {
  int32_t reach = (1023 - style.transparent_u_q10()) >> 10;
  if (reach < 0 && style.effect().cells != nullptr) {
    reach = 0;
  }
  const InkBox& ink = field.ink;
  return {max(field.x0_u, ink.x0_u - reach), max(field.y0_u, ink.y0_u - reach),
          min(field.x1_u(), ink.x1_u + reach),
          min(field.y1_u(), ink.y1_u + reach)};
}

// The first pixel whose centre may not lie before a place, and the first behind
// all whose centres may lie before it. [u -> px]
//
// Steps that are rounded down lead up to 1/4 px astray at the ends of the
// largest grid; products are rounded down as well.
inline constexpr int32_t kAstrayQ10 = 264;

inline int32_t first_pixel(const TextStyle& style,
                           int32_t origin_q10,
                           int32_t place_u) noexcept {
  // Products are below 2^30.
  const int32_t place_q10 = (place_u * style.size().raw) >> 6;
  return (origin_q10 + place_q10 + 511 - kAstrayQ10) >> 10;
}
inline int32_t end_pixel(const TextStyle& style,
                         int32_t origin_q10,
                         int32_t place_u) noexcept {
  return first_pixel(style, origin_q10 + 2 * kAstrayQ10, place_u);
}

// The pixels whose centres may lie within `limits` [u], and few others.
inline Rect upright_box(const Rect& limits,
                        const TextStyle& style,
                        const Placed& placed) noexcept {
  const int32_t up = -placed.y_q10;
  return {first_pixel(style, placed.x_q10, limits.x0),
          -end_pixel(style, up, limits.y1),
          end_pixel(style, placed.x_q10, limits.x1),
          -first_pixel(style, up, limits.y0)};
}

}  // namespace detail
}  // namespace inkcell
