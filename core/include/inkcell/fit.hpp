// Grid fitting: outlines whose strokes are moved to the grid of pixels, for
// small text that stands still.
//
//   inkcell::Fit fit;
//   INKCELL_TRY(inkcell::Fit::make(font, style, {}, fit));
//   style.set_fit(fit);
//
// Baselines and the heights that glyphs share come to lie between two rows of
// pixels, the x-height is rounded up to whole rows, horizontal strokes keep
// free rows between them. With FitOptions::across stems are whole pixels wide,
// and so are advances: lay out and measure with the style then.
//
// Fitting moves the points of outlines before painting. That costs about as
// much as decoding them. Glyphs of fields stay as designed.
#pragma once

#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/glyph_warp.hpp"
#include "inkcell/grid_hints.hpp"
#include "inkcell/status.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

namespace detail {
class AcrossFit;
class HeightFit;
}  // namespace detail

/// How far glyphs may change where they are fitted.
struct FitOptions {
  static constexpr uint16_t kAll = 256;

  /// Fits x, too: stems are whole pixels, and advances are the designed ones to
  /// the nearest pixel. Reads best to 11 px, and at any size on displays of 1
  /// and 2 bits.
  bool across = false;
  /// The display's levels: 0, many; 2 or 4. With 2 all strokes are whole
  /// pixels, and serifs are left out below 16 px.
  uint8_t levels = 0;
  /// How far points move towards the grid: 0 not at all, kAll all the way. For
  /// text that begins to move or comes to rest.
  uint16_t strength_q8 = kAll;
};

/// For Style::set_fit(); the options are a const Fit*.
extern const Fitter kGridFit;

/// The same for heights alone, in two thirds of the code: FitOptions::across
/// does nothing, and no advances are whole pixels.
extern const Fitter kFitHeights;

/// FitOptions{true, 2} and {true, 4} without a Fit, and without options: hints
/// are read anew for each glyph, and text of 40 px and more stays as designed.
/// Canvases of 1 and 2 bits take them by themselves (few_levels.hpp).
extern const Fitter kFitTwoLevels;
extern const Fitter kFitFourLevels;

/// FitOptions{true} and {} likewise, with advances of whole pixels: for strikes
/// of many levels (strike/strike.hpp).
extern const Fitter kFitGrey;
extern const Fitter kFitGreyHeights;

/// A font's hints at one size. Made once, constant afterwards, in the caller's
/// memory. The font's bytes must outlive it. For styles of the same size and
/// for glyphs of this font: others are drawn with the wrong hints.
class Fit {
 public:
  /// From here on glyphs of many levels are less and less fitted, and then no
  /// glyph is.
  static constexpr Q26_6 kFades = Q26_6::from_int(24);
  static constexpr Q26_6 kEnds = Q26_6::from_int(40);
  static constexpr uint32_t kMaxZones = 8;

  constexpr Fit() noexcept = default;

  /// Without hints in the font it moves baselines only, and in TrueType files
  /// the heights of lower case and capitals, at full strength. corrupt:
  /// GridHints::open; bad_argument: the levels or the strength. `out` is
  /// untouched unless the result is ok.
  static Status make(const Font& font,
                     const Style& style,
                     const FitOptions& options,
                     Fit& out) noexcept;

  const GridHints& hints() const noexcept { return hints_; }

  /// Whether advances are whole pixels.
  bool has_advances() const noexcept { return is_across_; }

  /// For Bilevel::threshold_px: diagonals and bowls get the weight that
  /// stems have as whole pixels.
  Q6_10 bilevel_weight() const noexcept;

 private:
  friend class detail::AcrossFit;
  friend class detail::HeightFit;
  friend class GridFit;

  struct Zone {
    int16_t flat_q6;  // [px]
    int16_t round_q6;
  };

  void set(const Font& font, Q26_6 size, const FitOptions& options) noexcept;

  // As designed, and as the x-height is scaled. [u -> px, Q6]
  int32_t px_q6(int32_t u) const noexcept {
    return (u * size_q6_ + (1 << 9)) >> 10;
  }
  int32_t height_q6(int32_t u) const noexcept {
    return (u * y_scale_q16_ + (1 << 15)) >> 16;
  }
  int32_t u_of(int32_t units) const noexcept;
  void add_knot(AxisMap& map, int32_t at_u, int32_t to_q6) const noexcept;
  void to_grid(int64_t& at_q10) const noexcept;
  void set_zones() noexcept;

  // Bytes before words: the smallest cores reach fewer of them at once.
  GridHints hints_;
  uint8_t levels_ = 0;
  bool is_across_ = false;
  bool drops_serifs_ = false;
  uint16_t strength_q8_ = 0;  // 0: glyphs stay as they are
  int32_t size_q6_ = 0;
  int32_t y_scale_q16_ = 0;  // Q6 px per u
  int32_t u_per_unit_q14_ = 0;
  int32_t stem_q6_ = 0;  // how wide most stems and bars are [px]
  int32_t bar_q6_ = 0;
  Zone zones_[kMaxZones] = {};
};

constexpr Style& Style::set_fit(const Fit& fit) noexcept {
  return set_fit(kGridFit, &fit);
}

}  // namespace inkcell
