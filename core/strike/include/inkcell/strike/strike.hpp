// Strikes: pictures of glyphs at one size, made by inkcell-fontgen --strike.
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
// most. So do those of 2 bits where text is not drawn in full contrast.
//
// A font of strikes alone, such as one made of BDF, has one size. It is drawn
// at that size and at whole multiples of it, each pixel a square, by upright
// styles without an effect; Font::check() answers `unsupported` to others.
// Glyphs stand on the nearest whole pixel.
#pragma once

#include <stdint.h>

#include "inkcell/coding.hpp"
#include "inkcell/fit.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

/// Codings of fonts with strikes, for Font::open(): the header of a font names
/// its own. Those of bits draw strikes of 1 bit only, in less code.
extern const Coding kStrikeCoding;  // strikes alone
extern const Coding kBitStrikeCoding;
extern const Coding kOutlineStrikeCoding;  // outlines, and strikes beside them
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
