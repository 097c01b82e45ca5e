// A glyph of outlines that is decoded once and drawn into many strips.
//
// Painter::glyph decodes a glyph anew for each strip, which costs about a tenth
// of drawing it. For large digits drawn in low strips:
//
//   PreparedGlyph digit;
//   INKCELL_TRY(PreparedGlyph::make(font, glyph, style, origin, ram, digit));
//   for each strip:  digit.draw(sink);
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell {

/// A glyph at one place, in RAM that the caller lends as long as it is used.
/// The font, the style and what it refers to must outlive it, unchanged.
class PreparedGlyph {
 public:
  /// Draws nothing.
  constexpr PreparedGlyph() noexcept = default;

  /// Places a glyph with its origin at `origin`. The workspace gives 8 bytes to
  /// each point and the rest to rows: 2.5 KB hold every glyph of a Latin face
  /// and 16 rows of 96 px. The picture is that of Painter::glyph.
  ///
  /// buffer_small: the workspace has less than 792 bytes, or 868 where pointers
  /// have 64 bits; of a TrueType file 868 and 968. no_glyph: there is no glyph
  /// of this id; one that a TrueType file lacks has no ink. unsupported: it is
  /// not one of outlines. `out` is untouched unless the result is ok.
  static Status make(const Font& font,
                     uint16_t glyph,
                     const Style& style,
                     Point origin,
                     Workspace workspace,
                     PreparedGlyph& out) noexcept;

  /// The pixels that the glyph may touch; empty if it has no ink.
  Rect box() const noexcept;

  /// Draws the part that lies in the sink's window. For one task at a time,
  /// because tasks would share the workspace.
  void draw(const Sink& sink) const noexcept;

 private:
  void* job_ = nullptr;  // in the workspace
};

}  // namespace inkcell
