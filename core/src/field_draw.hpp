// Coverage of rows of cells of fields.
#pragma once

#include <stdint.h>

#include "field_cell.hpp"
#include "inkcell/brush.hpp"
#include "span_writer.hpp"

namespace inkcell {
namespace detail {

inline FieldScale scale_of(const Brush& brush) noexcept {
  return {static_cast<uint32_t>(brush.size().raw) << 2, brush.bend_q14(),
          brush.bend_log2()};
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

// Upright text: pixels that all lie in the grid. `at` is the upper left one.
void draw_fields(const GlyphField& field,
                 const Brush& brush,
                 const Rect& pixels,
                 const FieldPosition& at,
                 const Sink& sink) noexcept;

// The distance at any position; beyond `reach_q22` its sign. [px, Q10]
int32_t fields_distance_q10(const GlyphField& field,
                            const Brush& brush,
                            const FieldPosition& at,
                            int32_t reach_q22) noexcept;

}  // namespace detail
}  // namespace inkcell
