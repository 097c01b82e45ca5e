// Turns one glyph into another, or into its own bold form, by moving the points
// of its outline.
//
//   OutlineMorph digit;
//   INKCELL_TRY(OutlineMorph::open(font, four, five, digit));
//   digit.draw(painter, style, origin, progress);  // for each strip
//
// The font must hold the pair (inkcell-fontgen --morph), in either direction,
// or the second masters of its glyphs (--axis wght=300..800).
// Strokes travel, bend and split. Any size, filter, weight, matrix and effect;
// no grid. Pairs that a font does not hold: GlyphMorph (morph.hpp).
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/style.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell::motion {

/// Points that are kept: RAM from a multiple of 4 on.
struct MorphPoints {
  Workspace ram;
  int32_t count = -1;  // -1: they are not made yet
};

/// A pair of glyphs. Refers to the font, which must outlive it.
class OutlineMorph {
 public:
  /// Draws nothing.
  constexpr OutlineMorph() noexcept = default;

  /// no_glyph: the font does not hold the pair. A glyph and itself is always a
  /// pair. `out` is untouched unless the result is ok. Binary search.
  static Status open(const Font& font,
                     uint16_t from,
                     uint16_t to,
                     OutlineMorph& out) noexcept;

  /// From a glyph to its second master: bolder, wider or slanted. no_glyph: the
  /// font holds none (inkcell-fontgen --axis wght=300..800). As open().
  static Status open_master(const Font& font,
                            uint16_t glyph,
                            OutlineMorph& out) noexcept;

  /// The same, or from the glyph to itself where the font holds none; draws
  /// nothing if the font lacks the glyph.
  static OutlineMorph to_master(const Font& font, uint16_t glyph) noexcept;

  /// The least workspace of a painter that draws any pair of the font. A strip
  /// of 16 rows of 96 px in one band takes 1.8 KB more. [bytes]
  static size_t workspace_bytes(const Font& font) noexcept;

  /// Draws with the glyph's origin at `origin`. Progress is clamped to 0..1. At
  /// its ends it draws the plain glyph, between them without grid fitting, and
  /// nothing if the painter's workspace is too small.
  void draw(const Painter& painter,
            const Style& style,
            Point origin,
            Q16_16 progress) const noexcept;

  /// The pixels that draw() may touch.
  Rect box(const Style& style, Point origin, Q16_16 progress) const noexcept;

  /// Between the advances of both glyphs. Progress is clamped to 0..1.
  Q26_6 advance(const Style& style, Q16_16 progress) const noexcept;

  uint16_t from() const noexcept { return from_; }
  uint16_t to() const noexcept { return to_; }

 private:
  friend class MorphFrame;

  // With a box nothing is drawn.
  void draw_or_box(const Painter& painter,
                   const Style& style,
                   Point origin,
                   Q16_16 progress,
                   MorphPoints* points,
                   Rect* box) const noexcept;

  const Font* font_ = nullptr;
  Span<const uint8_t> record_;
  uint16_t from_ = 0;
  uint16_t to_ = 0;
};

/// A morph at one progress and one place, drawn into many strips: the first
/// draw() makes the points, which takes a fifth of drawing a glyph of 96 px.
class MorphFrame {
 public:
  /// The morph and the style must outlive it, unchanged. `ram` begins at a
  /// multiple of 4, and has OutlineMorph::workspace_bytes() of the font, or
  /// nothing shows between the ends.
  MorphFrame(const OutlineMorph& morph,
             const Style& style,
             Point origin,
             Q16_16 progress,
             Workspace ram) noexcept
      : morph_(morph),
        style_(style),
        origin_(origin),
        progress_(progress),
        points_{ram} {}

  /// As OutlineMorph::draw(); any workspace of the painter will do.
  void draw(const Painter& painter) noexcept;

 private:
  const OutlineMorph& morph_;
  const Style& style_;
  Point origin_;
  Q16_16 progress_;
  MorphPoints points_;
};

}  // namespace inkcell::motion
