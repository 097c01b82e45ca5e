// Strokes along the edges of glyphs, alone or with what they enclose.
//
//   constexpr Stroke kStroke(kFilterText, Q6_10::from_int(1));
//   style.set_effect(kStroke);
//
// With fonts of outlines a stroke costs two to three times as much as plain
// text. Fonts of fields must reach as far as both edges do: check_reach() in
// shadow.hpp says so.
#pragma once

#include <stdint.h>

#include "inkcell/effect.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {

/// On which side of the edge a stroke lies.
enum class StrokePlace : uint8_t { inner, centred, outer };

/// A stroke, in place of the inside: what `outer` covers and `inner` does not.
/// 532 bytes. The style's own filter does not matter.
struct Stroke : Effect {
  /// `width_px` wide, 0 to 4 px, along the edge that `edge` draws.
  constexpr Stroke(const Filter& edge,
                   Q6_10 width_px,
                   StrokePlace place = StrokePlace::centred) noexcept
      : Effect(detail::kStrokeMixer),
        outer(moved(edge, outside_of(width_px, place))),
        inner(moved(edge, outside_of(width_px, place) - width_px.raw)) {}

  Filter outer;
  Filter inner;

 private:
  static constexpr int32_t outside_of(Q6_10 width_px,
                                      StrokePlace place) noexcept {
    return place == StrokePlace::outer     ? width_px.raw
           : place == StrokePlace::centred ? width_px.raw / 2
                                           : 0;
  }
  static constexpr Filter moved(const Filter& edge, int32_t by_q10) noexcept {
    return with_weight(edge, Q6_10::from_raw(static_cast<int16_t>(by_q10)));
  }
};

/// Draws a stroke and what it encloses at once, from one distance a pixel. The
/// stroke extends below the fill's edge, so that no gap shows between them.
/// Draws in the intersection of both sinks' windows: up to kMaxSpan pixels of a
/// row go to the stroke's sink, then the same pixels to the fill's.
struct StrokeAndFill : Effect {
  /// `edges` must outlive it.
  constexpr explicit StrokeAndFill(const Stroke& edges,
                                   const Sink* fill_sink = nullptr) noexcept
      : Effect(detail::kStrokeAndFillMixer), stroke(&edges), fill(fill_sink) {}
  explicit StrokeAndFill(const Stroke&&, const Sink* = nullptr) = delete;

  const Stroke* stroke;
  /// Over the same strip as the stroke's sink, of another colour: set it anew
  /// for each strip. Nothing is drawn without one.
  const Sink* fill;
};

}  // namespace inkcell
