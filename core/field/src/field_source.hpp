// The sources of fonts of fields, and of single fields.
#pragma once

#include "field_rows.hpp"
#include "inkcell/field/glyph_field.hpp"
#include "rows/source.hpp"

namespace inkcell::detail {

// A glyph of a field.
struct __attribute__((may_alias)) FieldJob : GlyphJob {
  GlyphField field;
  FieldRows rows;
  Placed placed;

  // Where the band's first sample begins. [samples of the screen, Q8]
  int32_t band_x_q8() const noexcept {
    return first_column(box) * plan.columns * 256 + band.x_q8;
  }
  int32_t band_y_q8() const noexcept {
    return box.y0 * plan.rows * 256 + band.y_q8;
  }
};

}  // namespace inkcell::detail
