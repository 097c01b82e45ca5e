// Fonts of strikes alone: pictures of glyphs at one size, made of a bitmap font
// or by inkcell-fontgen --strike-only.
//
//   Font font;
//   INKCELL_TRY(Font::open(fonts::terminus, kBitStrikeCoding, font));
//   Painter(canvas).text(font, Style(16_px), pen, "12:34");
//
// Such a font is drawn at its size and at whole multiples of it, each pixel a
// square, by upright styles with kFilterArea and without an effect, whose
// fitting does not matter; Font::check() answers `unsupported` to others.
// Glyphs stand on the nearest whole pixel. Nothing of outlines is linked.
#pragma once

#include "inkcell/coding.hpp"

namespace inkcell {

/// For Font::open(): the header of a font names its own. That of bits draws
/// strikes of 1 bit and no others, in less code.
extern const Coding kStrikeCoding;
extern const Coding kBitStrikeCoding;

}  // namespace inkcell
