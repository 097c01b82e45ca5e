// Strikes beside outlines: pictures of glyphs at some sizes, made by
// inkcell-fontgen --strike.
//
//   Font font;
//   INKCELL_TRY(Font::open(fonts::sans, kOutlineStrikeCoding, font));
//   Painter(canvas).text(font, Style(12_px), pen, "12:34");
//
// Beside outlines a strike changes no picture, only its cost. It is drawn where
// the style has its size, fit and effect, is upright, and takes kFilterArea,
// and where the glyph stands on a whole pixel; all else is drawn from outlines.
// Text on canvases of 1 and 2 bits has whole pixels by itself; other canvases
// take the styles below. Strikes of 4 bits differ from outlines by 8/255 at
// most; those of 2 bits differ by a level where text is not drawn in full
// contrast.
#pragma once

#include <stdint.h>

#include "inkcell/coding.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

/// For Font::open(): the header of a font names its own. That of bits draws
/// strikes of 1 bit and no others, in less code; the other one takes more time
/// for those. kOutlineCoding opens such fonts too, and passes strikes over.
extern const Coding kOutlineStrikeCoding;
extern const Coding kOutlineBitStrikeCoding;

namespace detail {
// The options of styles for strikes of many levels: their address tells the fit
// without the fitter, which would be linked.
inline constexpr uint8_t kHeightsMark = 1;
inline constexpr uint8_t kBothMark = 2;
}  // namespace detail

/// The style that strikes of 4 bits serve: fitted to the grid of pixels, with
/// whole advances. For canvases of many levels.
constexpr Style strike_style(Q26_6 size) noexcept {
  return Style(size).set_fit(kFitGrey, &detail::kBothMark);
}
/// The same where heights alone are fitted, of strikes `vertical`. Advances are
/// whole all the same.
constexpr Style strike_height_style(Q26_6 size) noexcept {
  return Style(size).set_fit(kFitGreyHeights, &detail::kHeightsMark);
}

}  // namespace inkcell
