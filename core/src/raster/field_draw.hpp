// Coverage of cells of primitives.
#pragma once

#include <stdint.h>

#include "base/config.hpp"
#include "cells/field_cell.hpp"
#include "inkcell/text_style.hpp"
#include "sink/span_writer.hpp"

namespace inkcell {
namespace detail {

inline FieldScale scale_of(const TextStyle& style) noexcept {
  return {static_cast<uint32_t>(style.size().raw) << 2, style.bend_q14(),
          style.bend_shift()};
}

// The centre of a pixel in the glyph, in the two units that it takes to find a
// cell and to evaluate it. Beyond the grid the px may wrap.
struct FieldPosition {
  int32_t x_q16;  // [u]
  int32_t y_q16;
  uint32_t x_q20;  // [px from the origin, y up]
  uint32_t y_q20;
};

// What a field is evaluated at. [px, Q20 -> Q8]
inline uint32_t q8_of(uint32_t position_q20) noexcept {
  return static_cast<uint32_t>(wrapped(position_q20) >> 12);
}

// The distance from which on, on both sides, coverage is 0 or 255. [px, Q22]
inline int32_t reach_of(const Filter& filter) noexcept {
  const int32_t out =
      filter.outside_q10 < 0 ? -filter.outside_q10 : filter.outside_q10;
  const int32_t in =
      filter.inside_q10 < 0 ? -filter.inside_q10 : filter.inside_q10;
  return ((out > in ? out : in) + 1) << 12;
}

// Where half of what is cut off on the way to 1/256 px is added. [px, Q20]
inline constexpr int32_t kHalfQ20 = 1 << 11;

// px times the step of a px, in u, below 2^31; rounded down. [Q10, Q16 -> Q16]
inline int32_t u_of_px(int32_t px_q10, int32_t step_q16) noexcept {
#if defined(__ARM_ARCH_6M__)
  // No long products there: px and 1/1024 px, and of the latter's product the
  // upper and the lower part.
  const auto whole = static_cast<uint32_t>(px_q10 >> 10);
  const auto rest = static_cast<uint32_t>(px_q10 & 1023);
  const auto step = static_cast<uint32_t>(step_q16);
  return wrapped(whole * step +
                 ((rest * (step >> 8) + (rest * (step & 255) >> 8)) >> 2));
#else
  return static_cast<int32_t>((int64_t{px_q10} * step_q16) >> 10);
#endif
}

struct Placed;
struct Upright;

// Pixels of upright text whose centres lie in the limits of what may show, and
// where the upper left one is.
struct Upright {
  Rect pixels;
  FieldPosition at;

  // Goes on to a row below. Behind the last one it may be nowhere.
  void go_down(const TextStyle& style, int32_t count) noexcept {
    at.y_q16 =
        wrapped(static_cast<uint32_t>(at.y_q16) -
                times(count, static_cast<uint32_t>(style.step_along_q16())));
    at.y_q20 -= static_cast<uint32_t>(count) << 20;
  }
};

// The glyph's pixels that lie in the window.
Upright place_upright(const GlyphField& field,
                      const TextStyle& style,
                      const Placed& placed,
                      const Rect& window) noexcept;

// Draws what is upright, without a painter.
void draw_upright(const GlyphField& field,
                  const TextStyle& style,
                  const Placed& placed,
                  const Sink& sink) noexcept;

// draw_field of what is placed.
__attribute__((always_inline)) inline void draw_near(
    const GlyphField& field,
    const TextStyle& style,
    const Placed& placed,
    const Sink& sink) noexcept {
  if (style.drawer() != nullptr) {
    style.drawer()(field, style, placed, sink);
  } else {
    draw_upright(field, style, placed, sink);
  }
}

// Draws cells of primitives.
void draw_fields(const GlyphField& field,
                 const TextStyle& style,
                 const Placed& placed,
                 const Sink& sink) noexcept;

// The distance at any position; beyond `reach_q22` its sign. [px, Q10]
int32_t fields_distance_q10(const GlyphField& field,
                            const TextStyle& style,
                            const FieldPosition& at,
                            int32_t reach_q22) noexcept;

}  // namespace detail
}  // namespace inkcell
