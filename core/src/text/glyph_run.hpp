// Glyphs of a run on their way to the band by band drawing: where they stand,
// in px, and who draws them.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "inkcell/painter.hpp"
#include "outlines/outline_glyph.hpp"
#include "place/position.hpp"
#include "place/style_parts.hpp"
#include "text/advances.hpp"

namespace inkcell::detail {

// What a run's font units are in px: computed once, because it takes a
// division. [px per unit, Q10 with 20 more bits]
class UnitScale {
 public:
  UnitScale(const Font& font, const Style& style) noexcept {
    // 2^24 sizes over the em, to the nearest: 14 bits, then what is left and 10
    // more, so that 32 are enough.
    const uint32_t em = font.units_per_em();
    const uint32_t size_q20 = static_cast<uint32_t>(style.size().raw) << 14;
    const uint32_t whole = size_q20 / em;
    const uint32_t rest = size_q20 - whole * em;
    scale_ = (int64_t{whole} << 10) + ((rest << 10) + em / 2) / em;
  }

  // At most 2^24 units times 2^36: within int64_t. Both roundings are to the
  // nearest, so that whole pixels are met exactly.
  // Not inline for its size.
  __attribute__((noinline)) int64_t to_px_q10(int32_t units) const noexcept {
    if (units == 0) {
      return 0;  // most glyphs stand on the baseline
    }
    return (clamp_to(units, kMaxUnits) * scale_ + (1 << 19)) >> 20;
  }

 private:
  int64_t scale_;
};

// False: the glyph is too far away. Not inline: what it takes of the stack is
// free again when the glyph is drawn.
__attribute__((noinline)) inline bool place_near(const UnitScale& scale,
                                                 const Style& style,
                                                 const Point& origin,
                                                 const PositionedGlyph& at,
                                                 Placed& out) noexcept {
  const int64_t along = scale.to_px_q10(at.x);
  const int64_t across = scale.to_px_q10(at.y);
  const FinePoint from = origin;
  return out.set(
      style.is_upright()
          ? FinePoint(from.x_q10 + along, from.y_q10 - across)
          : StyleParts::slant(style).place(style, from, along, across));
}

// Ink that is not there yet, to add() to.
inline constexpr TextMeasure kNoInk = {0, INT32_MAX, INT32_MAX, INT32_MIN,
                                       INT32_MIN};

inline void add_ink(const Font& font,
                    const PositionedGlyph& at,
                    TextMeasure& sum) noexcept {
  GlyphMetrics ink;
  if (font.glyph_metrics(at.glyph, ink) == Status::ok &&
      ink.x_max > ink.x_min) {
    sum.x_min = min(sum.x_min, at.x + ink.x_min);
    sum.x_max = max(sum.x_max, at.x + ink.x_max);
    sum.y_min = min(sum.y_min, at.y + ink.y_min);
    sum.y_max = max(sum.y_max, at.y + ink.y_max);
  }
}

// Width and ink of what a cursor has left.
template <typename Cursor>
__attribute__((always_inline)) inline TextMeasure measure_line(
    const Font& font, Cursor& cursor) noexcept {
  TextMeasure sum = kNoInk;
  PositionedGlyph at;
  while (cursor.next(at)) {
    add_ink(font, at, sum);
  }
  if (sum.x_max < sum.x_min) {
    sum = {};
  }
  sum.advance = cursor.advance();
  return sum;
}

// All glyphs of a cursor: see Painter::lay_out().
template <typename Cursor>
__attribute__((always_inline)) inline Status lay_out_line(
    Cursor& cursor,
    Span<PositionedGlyph> out,
    Span<const PositionedGlyph>& glyphs) noexcept {
  PositionedGlyph at;
  size_t count = 0;
  while (cursor.next(at)) {
    if (count == out.size) {
      return Status::buffer_small;
    }
    out[count++] = at;
  }
  glyphs = {out.data, count};
  return Status::ok;
}

// The nearest whole pixel. Far away it may wrap, but not to where it would be
// seen.
inline Q26_6 whole_px(Q26_6 x) noexcept {
  const uint32_t sum = static_cast<uint32_t>(x.raw) + 32;
  return Q26_6::from_raw(static_cast<int32_t>(sum & ~uint32_t{63}));
}

// Room for a style that a painter adapts to its canvas.
union StyleRoom {
  StyleRoom() noexcept {}
  Style& style() noexcept { return style_; }

 private:
  Style style_;
};

// Draws positioned glyphs of a line, one after the other. What it is made of
// must outlive it.
class RunDrawer {
 public:
  // Inline: a program with text alone has no other.
  __attribute__((always_inline)) RunDrawer(const Painter& painter,
                                           const Font& font,
                                           const Style& style) noexcept
      : given_(style),
        run_{painter, &font, &painter.adapted(style, room_.style())},
        scale_(font, style) {}
  RunDrawer(const RunDrawer&) = delete;
  RunDrawer& operator=(const RunDrawer&) = delete;

  // What glyphs are drawn with.
  const Style& style() const noexcept { return *run_.style; }

  // Before the first glyph. Whole-pixel advances count from a whole pixel.
  void begin(Point origin, bool is_in_whole_px) noexcept {
    origin_ = origin;
    if (is_in_whole_px) {
      origin_.x = whole_px(origin.x);
    }
  }

  __attribute__((always_inline)) void draw(const PositionedGlyph& at) noexcept {
    Placed placed;
    if (place_near(scale_, given_, origin_, at, placed)) {
      run_.painter.drawer().draw(run_, at.glyph, placed);
    }
  }

  // The glyphs that a cursor of text or of a shaped run gives.
  template <typename Cursor>
  __attribute__((always_inline)) void draw_line(Point origin,
                                                Cursor& cursor) noexcept {
    begin(origin, cursor.is_in_whole_px());
    PositionedGlyph at;
    while (cursor.next(at)) {
      draw(at);
    }
  }

 protected:
  StyleRoom room_;
  const Style& given_;
  GlyphRun run_;
  UnitScale scale_;
  Point origin_;
};

// The same in several faces; glyphs of faces beyond the last are left out.
class FacesDrawer : public RunDrawer {
 public:
  FacesDrawer(const Painter& painter,
              const Face& face,
              Span<const Face> fallback) noexcept
      : RunDrawer(painter, *face.font, *face.style),
        face_(face),
        fallback_(fallback) {}

  void draw(const PositionedGlyph& at) noexcept {
    if (at.face > fallback_.size) {
      return;
    }
    if (at.face != drawn_face_) {
      const Face& own = at.face == 0 ? face_ : fallback_[at.face - 1u];
      INKCELL_ASSERT(own.font != nullptr && own.style != nullptr);
      drawn_face_ = at.face;
      run_.font = own.font;
      run_.style = &run_.painter.adapted(*own.style, room_.style());
      run_.state = 0;
    }
    RunDrawer::draw(at);
  }

 private:
  Face face_;
  Span<const Face> fallback_;
  uint32_t drawn_face_ = 0;
};

// Draws nothing, but adds up the boxes of glyphs, as a painter draws them.
struct BoxDrawer : GlyphDrawer {
  Rect sum;

  explicit BoxDrawer(const Painter& painter) noexcept
      : GlyphDrawer{add, painter.drawer().phase_shift} {}

 private:
  static void add(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept;
};

// What kDrawPlain does.
void draw_plain(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept;

// The nearest place at which a drawer draws glyphs.
inline Placed at_phase(Placed placed, uint32_t phase_shift) noexcept {
  const int32_t half = (1 << phase_shift) >> 1;
  const auto nearest = [=](int32_t q10) noexcept {
    return (q10 + half) & -(1 << phase_shift);
  };
  return {nearest(placed.x_q10), nearest(placed.y_q10)};
}

// The box of a glyph, at that place.
Rect box_of(const GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept;

}  // namespace inkcell::detail
