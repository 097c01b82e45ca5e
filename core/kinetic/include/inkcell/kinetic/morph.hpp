// One glyph becomes another through their distances.
//
//   GlyphMorph digit(font, size, kFilterMotion, memory);
//   INKCELL_TRY(digit.set(four, five));
//   digit.step(progress, scratch);
//   for each strip:  digit.draw(x, y, sink);
//
// Holes and strokes open and close by themselves. The area goes evenly from one
// glyph to the other, and both ends are the plain glyphs, bit by bit.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/fixed.hpp"
#include "inkcell/font.hpp"
#include "inkcell/kinetic/distance_grid.hpp"
#include "inkcell/kinetic/grid_blend.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell {
namespace kinetic {

/// Where glyphs stand in the box that a morph draws in. [px]
struct MorphBox {
  int32_t width = 0;
  int32_t height = 0;
  int32_t baseline = 0;  // below the upper edge
  /// A sample for 2^scale_log2 x 2^scale_log2 px. Best is the greatest scale
  /// at which strokes are 4 samples wide: 0 at 48 px, 1 at 96 px for a face of
  /// regular weight. Areas and strokes narrower than 3 samples waver, strokes
  /// wider than 8 come and go at once.
  int32_t scale_log2 = 1;
};

/// RAM for the three grids of a box: of both glyphs, and of what is between.
/// [bytes]
constexpr size_t morph_bytes(const MorphBox& box) noexcept {
  return 3 * static_cast<size_t>(
                 DistanceGrid::samples_of(box.width, box.scale_log2) *
                 DistanceGrid::samples_of(box.height, box.scale_log2));
}

/// A glyph on its way to another. 180 bytes and the grids, in the caller's
/// memory. What it refers to must outlive it.
class GlyphMorph {
 public:
  GlyphMorph(const Font& font,
             Q26_6 size,
             const Filter& filter,
             const MorphBox& box,
             Span<int8_t> grids,
             Workspace workspace = {}) noexcept;
  GlyphMorph(const Font&,
             Q26_6,
             const Filter&&,
             const MorphBox&,
             Span<int8_t>,
             Workspace = {}) = delete;
  GlyphMorph(const GlyphMorph&) = delete;
  GlyphMorph& operator=(const GlyphMorph&) = delete;

  /// Takes the distances of both glyphs, each in the middle of the box by its
  /// advance; of one that is known from before it costs nothing. Progress is 0.
  ///
  /// buffer_small: fewer grid bytes than morph_bytes() of the box.
  /// bad_argument: the size does not fit the scale, as DistanceGrid::paint().
  Status set(uint16_t from, uint16_t to) noexcept;

  /// How far it has come, 0 to 1; clamped. Several morphs may share a scratch.
  void step(Q16_16 progress, GridHistogram& scratch) noexcept;

  /// Draws the box with its upper left corner at pixel (x, y): whole pixels.
  /// What glyphs have beyond the box is cut off. Nothing is drawn where x or y
  /// is beyond +-32767.
  void draw(int32_t x, int32_t y, const Sink& sink) const noexcept;

  /// The same with another filter: a weight, a glow, an outline's edge.
  void draw(int32_t x,
            int32_t y,
            const Filter& filter,
            const Sink& sink) const noexcept;

  /// The pixels that it may touch.
  Rect box(int32_t x, int32_t y) const noexcept {
    return {x, y, x + box_.width, y + box_.height};
  }

  uint16_t from() const noexcept { return from_; }
  uint16_t to() const noexcept { return to_; }
  Q16_16 progress() const noexcept { return progress_; }
  /// What keeps the area: a distance. [samples]
  Fixed<int32_t, 13> cutoff() const noexcept { return cutoff_; }

 private:
  Point origin_of(uint16_t glyph) const noexcept;
  Status paint(uint16_t glyph, DistanceGrid& grid) noexcept;

  static constexpr uint16_t kNone = 0xffff;

  const Font& font_;
  Q26_6 size_;
  const Filter& filter_;
  MorphBox box_;
  Workspace workspace_;
  DistanceGrid grid_a_;
  DistanceGrid grid_b_;
  DistanceGrid between_;
  GridBlend blend_;
  Fixed<int32_t, 13> cutoff_;
  Q16_16 progress_;
  uint16_t from_ = kNone;
  uint16_t to_ = kNone;
};

}  // namespace kinetic
}  // namespace inkcell
