// Shadows and glows, which are filters, and how far a font's distances reach.
//
// With fonts of fields they cost no more than plain text; with fonts of
// outlines a glow of 4 px costs four to five times as much. Draw a shadow
// first, with its own style and colour, at the text's origin plus the shadow's
// offset (any 1/64 px); then draw the text.
//
// Distances of fields end at the font's band (FontRange::band_u; --band-px of
// inkcell-fontgen), and a filter that reaches beyond is cut off there. For
// outlines the device makes distances as far as the filter reaches.
#pragma once

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

/// beyond_band: at `size`, one of the filter's cutoffs is farther from the edge
/// than the font's distances are good. Distances of outlines are good
/// everywhere.
constexpr Status check_reach(const FontRange& range,
                             Q26_6 size,
                             const Filter& filter) noexcept {
  const int32_t outside_q10 = -filter.outside_q10;
  const int64_t reach_q10 =
      outside_q10 > filter.inside_q10 ? outside_q10 : filter.inside_q10;
  // The band is 1/1024 em, so that both sides are 1/1024 px, Q6.
  return reach_q10 * 64 > (int64_t{range.band_u} + 1) * size.raw
             ? Status::beyond_band
             : Status::ok;
}

/// A soft edge: a Gaussian from `reach_px` outside to as far inside.
constexpr Filter shadow_filter(Q6_10 reach_px) noexcept {
  FilterSpec spec;
  spec.outside_px.raw = static_cast<int16_t>(-reach_px.raw);
  spec.inside_px = reach_px;
  spec.profile = FilterProfile::gaussian;
  return make_filter(spec);
}

/// Full coverage inside. Outside, coverage falls to 0 at `reach_px` from the
/// edge.
constexpr Filter glow_filter(Q6_10 reach_px) noexcept {
  FilterSpec spec;
  spec.outside_px.raw = static_cast<int16_t>(-reach_px.raw);
  spec.exponent = Fixed<uint16_t, 8>::from_int(2);
  return make_filter(spec);
}

}  // namespace inkcell
