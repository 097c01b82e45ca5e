// Turns one glyph into another by their distances.
//
//   GlyphMorph digit(font, size, kFilterMotion, memory);
//   INKCELL_TRY(digit.set(four, five, ram));
//   digit.step(progress, scratch);
//   for each strip:  digit.draw(x, y, painter);
//
// Holes and strokes open and close by themselves. The area changes evenly, and
// at both ends the picture is the plain glyph, bit by bit.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/motion/distance_grid.hpp"
#include "inkcell/motion/grid_blend.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell::motion {

/// The box in which a morph draws. [px]
struct MorphBox {
  int32_t width = 0;
  int32_t height = 0;
  int32_t baseline = 0;  // below the upper edge
  /// A sample covers 2^scale_log2 x 2^scale_log2 px. Best is the greatest scale
  /// at which strokes are 4 samples wide: 0 at 48 px, 1 at 96 px for a regular
  /// face. Strokes narrower than 3 samples waver; strokes wider than 8 appear
  /// and vanish at once.
  int32_t scale_log2 = 1;
};

/// RAM for the three grids of a box: both glyphs and the blend. [bytes]
constexpr size_t morph_bytes(const MorphBox& box) noexcept {
  return 3 * static_cast<size_t>(
                 DistanceGrid::samples_of(box.width, box.scale_log2) *
                 DistanceGrid::samples_of(box.height, box.scale_log2));
}

/// A glyph that becomes another. 180 bytes and the grids, in the caller's
/// memory. All that it refers to must outlive it.
class GlyphMorph {
 public:
  GlyphMorph(const Font& font,
             Q26_6 size,
             const Filter& filter,
             const MorphBox& box,
             Span<int8_t> grids) noexcept;
  GlyphMorph(const Font&,
             Q26_6,
             const Filter&&,
             const MorphBox&,
             Span<int8_t>) = delete;
  GlyphMorph(const GlyphMorph&) = delete;
  GlyphMorph& operator=(const GlyphMorph&) = delete;

  /// Reads the distances of both glyphs, each centred in the box by its
  /// advance, faster with RAM that is lent for the call. Progress becomes 0. A
  /// glyph that is already loaded costs nothing.
  ///
  /// buffer_small: fewer grid bytes than morph_bytes() of the box.
  /// bad_argument: the size does not fit the scale, see DistanceGrid::paint().
  Status set(uint16_t from, uint16_t to, Workspace ram = {}) noexcept;

  /// Sets the progress, clamped to 0..1. Morphs may share `scratch`.
  void step(Q16_16 progress, GridHistogram& scratch) noexcept;

  /// Draws the box with its upper left corner at pixel (x, y). Glyphs are
  /// clipped to the box. If x or y is beyond +-32767 nothing is drawn.
  void draw(int32_t x, int32_t y, const Painter& painter) const noexcept;

  /// The same with another filter, for a weight, a glow or an outline.
  void draw(int32_t x,
            int32_t y,
            const Filter& filter,
            const Painter& painter) const noexcept;

  /// The pixels that it may touch.
  Rect box(int32_t x, int32_t y) const noexcept {
    return {x, y, x + box_.width, y + box_.height};
  }

  uint16_t from() const noexcept { return from_; }
  uint16_t to() const noexcept { return to_; }
  Q16_16 progress() const noexcept { return progress_; }
  /// The offset of the edges that keeps the area. [samples]
  Fixed<int32_t, 13> cutoff() const noexcept { return cutoff_; }

 private:
  Point origin_of(uint16_t glyph) const noexcept;
  Status paint(uint16_t glyph, Workspace ram, DistanceGrid& grid) noexcept;

  static constexpr uint16_t kNone = 0xffff;

  const Font& font_;
  Q26_6 size_;
  const Filter& filter_;
  MorphBox box_;
  DistanceGrid grid_a_;
  DistanceGrid grid_b_;
  DistanceGrid between_;
  GridBlend blend_;
  Fixed<int32_t, 13> cutoff_;
  Q16_16 progress_;
  uint16_t from_ = kNone;
  uint16_t to_ = kNone;
};

}  // namespace inkcell::motion
