// Grid fitting: glyphs that give way to the grid of pixels, for text that
// stands still.
//
//   inkcell::Fit fit;
//   INKCELL_TRY(inkcell::Fit::make(font, brush, {}, fit));
//   brush.set_fitter(inkcell::fit_glyph, &fit);
//
// Heights only, unless stems are asked for: baselines and the heights that
// glyphs share come to lie between two rows of pixels, horizontal strokes fill
// whole rows. Distances stay those of the glyph (RowMap), so that a fitted
// glyph costs little more than another.
#pragma once

#include <stdint.h>

#include "inkcell/brush.hpp"
#include "inkcell/font.hpp"
#include "inkcell/hints.hpp"
#include "inkcell/render.hpp"
#include "inkcell/row_map.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

struct FitOptions {
  static constexpr uint16_t kAll = 256;

  /// How much of the way to the grid glyphs go: 0 none, kAll all of it. For
  /// text that begins to move or comes to rest.
  uint16_t strength_q8 = kAll;
  /// Moves each glyph by up to 1/4 px to the left or right, so that its stems
  /// look alike. Costs evenness of the gaps between glyphs.
  bool stems = false;
};

/// A font's hints at one size. Made once, constant afterwards, in the caller's
/// memory. The font's bytes must outlive it. For brushes of the same size and
/// for glyphs of this font: others are drawn, but fitted to what is not there.
class Fit {
 public:
  /// From here on glyphs are less and less fitted, and then not at all.
  static constexpr Q26_6 kFades = Q26_6::from_int(24);
  static constexpr Q26_6 kEnds = Q26_6::from_int(40);
  static constexpr uint32_t kMaxZones = 15;

  constexpr Fit() noexcept = default;

  /// Without hints in the font it moves baselines only. corrupt: Hints::open;
  /// bad_argument: the strength. `out` is untouched unless the result is ok.
  static Status make(const Font& font,
                     const Brush& brush,
                     const FitOptions& options,
                     Fit& out) noexcept;

 private:
  friend class GlyphFit;
  friend void fit_glyph(
      uint16_t, const Brush&, const void*, FinePoint&, RowMap&) noexcept;

  // What is left of a shift, or of any number below 2^22.
  int32_t weakened(int32_t shift) const noexcept {
    return (shift * strength_q8_) >> 8;
  }
  // Whether ink is above the zone; `zone` is its number and 1.
  bool is_bottom(uint32_t zone) const noexcept {
    return (bottoms_ >> zone & 1u) != 0;
  }
  int32_t sideways_q10(uint32_t glyph,
                       const Brush& brush,
                       const FinePoint& origin) const noexcept;

  Hints hints_;
  uint16_t strength_q8_ = 0;           // 0: glyphs stay as they are
  uint16_t stem_q10_ = 0;              // how wide stems are [px]; 0: they stay
  uint32_t bottoms_ = 0;               // bits of zones
  int32_t zones_q10_[kMaxZones] = {};  // flat edges [px]
};

/// The Fitter; `fit` is a const Fit*.
void fit_glyph(uint16_t glyph,
               const Brush& brush,
               const void* fit,
               FinePoint& origin,
               RowMap& rows) noexcept;

}  // namespace inkcell
