// Draws glyphs in any pose into strips, and finds what changed.
//
//   PoseRenderer renderer(font, Q26_6::from_int(48));
//   for (size_t i = 0; i < run.glyphs.size; ++i) {
//     const int32_t time = now - delay_of(stagger, i, run.glyphs.size);
//     posed[i] = place(font, run, i, where, pose_at(keys, time));
//   }
//   for each strip:  renderer.draw(posed, painter);
#pragma once

#include <stdint.h>

#include "inkcell/dirty_rects.hpp"
#include "inkcell/filter.hpp"
#include "inkcell/font.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/pose.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"
#include "inkcell/style.hpp"

namespace inkcell::motion {

/// Draws glyphs of one font and size. 400 bytes, in the caller's memory; all
/// that it refers to must outlive it. Not thread-safe: each task needs its own.
class PoseRenderer {
 public:
  /// `size` is for glyphs of scale 1, 4 to 1024 px to the em.
  PoseRenderer(const Font& font,
               Q26_6 size,
               const Filter& filter = kFilterMotion) noexcept
      : font_(font), size_(size), filter_(filter), style_(size, filter) {}
  PoseRenderer(const Font&, Q26_6, const Filter&&) = delete;
  PoseRenderer(const PoseRenderer&) = delete;
  PoseRenderer& operator=(const PoseRenderer&) = delete;

  /// Sets the size at scale 1, in px to the em, for later calls. The same range
  /// as in the constructor.
  void set_size(Q26_6 size) noexcept { size_ = size; }

  /// Draws glyphs in order, placed to 1/64 px. Cannot fail. Glyphs of opacity
  /// 0, larger than 1024 or smaller than 4 px to the em are left out. A glyph
  /// narrower than 4 px to the em is drawn at that width, so that a glyph that
  /// turns about an axis does not blink.
  ///
  /// Costs what the core needs; about 400 instructions for a glyph outside of
  /// the sink's window.
  void draw(Span<const PosedGlyph> glyphs, const Painter& painter) noexcept;

  /// The same of a morph, such as to a second master, in place of
  /// `glyph.glyph`. Between its ends the painter's workspace must have
  /// OutlineMorph::workspace_bytes() of the font, or nothing is drawn.
  void draw(const PosedGlyph& glyph,
            const OutlineMorph& morph,
            Q16_16 progress,
            const Painter& painter) noexcept;

  /// The pixels that a glyph may touch; empty if it is not drawn.
  Rect box(const PosedGlyph& glyph) const noexcept;
  Rect box(const PosedGlyph& glyph,
           const OutlineMorph& morph,
           Q16_16 progress) noexcept;

  /// Adds the areas in which `now` differs from `before`. Glyphs are compared
  /// by index; glyphs that only one of them has are changes, too.
  void add_changes(Span<const PosedGlyph> before,
                   Span<const PosedGlyph> now,
                   const Rect& screen,
                   DirtyRects& dirty) const noexcept;

 private:
  struct Map;

  bool map_of(const PosedGlyph& glyph, Map& out) const noexcept;
  Rect box_of(const PosedGlyph& glyph, const Map& map) const noexcept;
  bool make_style(const PosedGlyph& glyph, const Map& map) noexcept;

  const Font& font_;
  Q26_6 size_;
  const Filter& filter_;
  Filter weighted_;
  Style style_;
};

}  // namespace inkcell::motion
