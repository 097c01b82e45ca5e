// Text on canvases of 1 and 2 bits: fitted to the grid of pixels, and without
// strokes or dots that fall between pixels.
//
// These canvases do so by themselves: a Painter fits text whose style leaves
// that open, as styles do until Style::set_fit() or clear_fit(), before it
// measures and before it draws. A canvas also makes such a style:
//
//   constexpr Style kLine = MonoPagesCanvas::style(12_px);
//
// Fitted text is upright and smaller than 40 px; other text stays as designed.
// bilevel.hpp draws unfitted strokes with fewer breaks, for more code.
#pragma once

#include <stdint.h>

#include "inkcell/effect.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

extern const Fitter kFitTwoLevels;  // fit.hpp
extern const Fitter kFitFourLevels;

namespace detail {
// Draws a pixel for what would show none.
struct FewLevels : Effect {
  constexpr FewLevels(uint8_t level_count, uint8_t bits) noexcept
      : Effect(kFewLevelsMixer), levels(level_count), strike_bits(bits) {}
  uint8_t levels;  // 2 or 4
  // Strikes of so many bits look as what the canvas makes of coverage.
  uint8_t strike_bits;
};
inline constexpr FewLevels kTwoLevels{2, 1};
inline constexpr FewLevels kFourLevels{4, 2};
// The same on canvases of another threshold, and of dither.
inline constexpr FewLevels kShiftedTwoLevels{2, 0};
inline constexpr FewLevels kShiftedFourLevels{4, 0};

// For Sink::levels. Canvases name a rule by a weak reference, and codings whose
// glyphs it changes bring its object: see band.cpp.
struct LevelRule {
  // Makes `room` the style that text is drawn with, and returns it; the given
  // one if that says it all.
  const Style& (*adapt)(const LevelRule& rule,
                        const Style& given,
                        bool can_fit,
                        Style& room) noexcept;
  // Its fitter, without a style.
  const Fitter* (*fitter)(const LevelRule& rule,
                          const Style& given,
                          bool can_fit) noexcept;
  const Fitter* own;
  const FewLevels* effect;
};
extern const LevelRule kTwoLevelRule;
extern const LevelRule kFourLevelRule;
extern const LevelRule kShiftedTwoLevelRule;
extern const LevelRule kShiftedFourLevelRule;
}  // namespace detail

/// What text of a size is drawn with on canvases of 1 bit.
constexpr Style two_level_style(Q26_6 size) noexcept {
  return Style(size)
      .set_fit(kFitTwoLevels, nullptr)
      .set_effect(detail::kTwoLevels);
}
/// Likewise, on 2 bits.
constexpr Style four_level_style(Q26_6 size) noexcept {
  return Style(size)
      .set_fit(kFitFourLevels, nullptr)
      .set_effect(detail::kFourLevels);
}

}  // namespace inkcell
