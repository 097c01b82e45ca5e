// Glyphs that do not stand upright.
#pragma once

#include <stdint.h>

#include "cells/field_cell.hpp"
#include "inkcell/render.hpp"
#include "inkcell/text_style.hpp"
#include "raster/field_draw.hpp"

namespace inkcell {
namespace detail {

// The values of fields from which on, on both sides, distances on the screen
// are not below `reach_q22`, or just so. At most 2^30. [px of the style's size]
int32_t far_q22(const TextStyle& style, int32_t reach_q22) noexcept;

// Makes planes of px on the screen of all fields at one point, for combine_q22
// to round their vertices there. Values from `far_q22` on only keep their sign.
void stretch_terms(const TextStyle& style,
                   int32_t far_q22,
                   FieldTerms& terms) noexcept;

// fields_distance_q10 and samples_distance_q10 for stretched styles. [px on
// the screen, Q10]
int32_t stretched_fields_q10(const GlyphField& field,
                             const TextStyle& style,
                             const FieldPosition& at,
                             int32_t reach_q22) noexcept;
int32_t stretched_samples_q10(const GlyphField& field,
                              const TextStyle& style,
                              const FieldPosition& at) noexcept;

}  // namespace detail
}  // namespace inkcell
