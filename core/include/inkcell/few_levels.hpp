// Text on canvases of 1 and 2 bits: fitted to the grid of pixels, and without
// strokes or dots that fall between pixels.
//
// These canvases do so by themselves: Painter and TextBox::draw() fit text
// whose style leaves that open, as styles do until Style::set_fitter(). What
// has no canvas, such as lay_out(), ScrollingLabel::make() or measure(), needs
// a style that is fitted already: the canvas makes one.
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
extern const Mixer kFewLevelsMixer;

// Draws a pixel for what would show none.
struct FewLevels : Effect {
  constexpr explicit FewLevels(uint8_t level_count) noexcept
      : Effect(kFewLevelsMixer), levels(level_count) {}
  uint8_t levels;  // 2 or 4
};
inline constexpr FewLevels kTwoLevels{2};
inline constexpr FewLevels kFourLevels{4};

// For Sink::adapt.
const Style& adapt_to_two_levels(const Style& given,
                                 bool is_laid_out,
                                 Style& room) noexcept;
const Style& adapt_to_four_levels(const Style& given,
                                  bool is_laid_out,
                                  Style& room) noexcept;
}  // namespace detail

/// What text of a size is drawn with on canvases of 1 bit, and of 2.
constexpr Style two_level_style(Q26_6 size) noexcept {
  return Style(size)
      .set_fitter(&kFitTwoLevels, nullptr)
      .set_effect(detail::kTwoLevels);
}
constexpr Style four_level_style(Q26_6 size) noexcept {
  return Style(size)
      .set_fitter(&kFitFourLevels, nullptr)
      .set_effect(detail::kFourLevels);
}

}  // namespace inkcell
