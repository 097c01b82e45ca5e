// Outlines, shadows and glows, all from the distances of the same font.
//
// Filters make weight (with_weight), shadow_filter and glow_filter. With fonts
// of fields they cost no more than plain text. With fonts of outlines a weight
// costs two to three times as much, a glow of 4 px four to five. Draw a shadow
// first, with its own style and colour, at the text's origin plus the shadow's
// offset (any 1/64 px); then draw the text. An outline is an effect:
//
//   const Outline outline = make_outline(kFilterText, width, place);
//   INKCELL_TRY(check_reach(font.range(), size, outline.outer));
//   INKCELL_TRY(check_reach(font.range(), size, outline.inner));
//   style = Style(size, outline.outer);
//   style.set_effect(outline_effect(outline.inner));
//
// Distances of fields end at the font's band (FontRange::band_u; --band-px of
// inkcell-fontgen), and an effect that reaches beyond is cut off there. For
// outlines the device makes distances as far as the filter reaches.
#pragma once

#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

/// beyond_band: at `size`, one of the filter's cutoffs is farther from the edge
/// than the font's distances are good. Distances of outlines are good
/// everywhere.
Status check_reach(const FontRange& range,
                   Q26_6 size,
                   const Filter& filter) noexcept;

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

/// On which side of the edge an outline lies.
enum class OutlinePlace : uint8_t { inner, centred, outer };

/// The filters of an outline's two edges, 536 bytes. The caller owns them.
struct Outline {
  Filter outer;  // for Style
  Filter inner;  // for what is painted
};

/// An outline `width_px` wide, 0 to 4 px, along the edge that `edge` draws.
constexpr Outline make_outline(const Filter& edge,
                               Q6_10 width_px,
                               OutlinePlace place) noexcept {
  const int32_t out = place == OutlinePlace::outer     ? width_px.raw
                      : place == OutlinePlace::centred ? width_px.raw / 2
                                                       : 0;
  const auto weight = [](int32_t raw) noexcept {
    return Q6_10::from_raw(static_cast<int16_t>(raw));
  };
  return {with_weight(edge, weight(out)),
          with_weight(edge, weight(out - width_px.raw))};
}

namespace detail {
extern const Mixer kOutlineMixer;
}  // namespace detail

/// Draws what the style's filter covers and `inner`, which is Outline::inner,
/// does not. The filter must outlive the style.
constexpr Effect outline_effect(const Filter& inner) noexcept {
  return {&detail::kOutlineMixer, &inner, 0};
}
Effect outline_effect(const Filter&&) = delete;

/// Options of outline_and_fill_effect. The caller sets `fill` anew for each
/// strip, like the sink that the outline goes to.
struct OutlineAndFill {
  const Filter* inner = nullptr;  // Outline::inner: the edge of the fill
  const Sink* fill = nullptr;     // over the same strip, of another colour
};

namespace detail {
extern const Mixer kOutlineAndFillMixer;
}  // namespace detail

/// Draws outline and fill at once, from one distance a pixel. The outline
/// extends below the fill's edge, so that no gap shows between them. Draws in
/// the intersection of both sinks' windows: up to kMaxSpan pixels of a row go
/// to the outline's sink, then the same pixels to the fill's. The options must
/// outlive the style.
constexpr Effect outline_and_fill_effect(const OutlineAndFill& both) noexcept {
  return {&detail::kOutlineAndFillMixer, &both, 0};
}
Effect outline_and_fill_effect(const OutlineAndFill&&) = delete;

}  // namespace inkcell
