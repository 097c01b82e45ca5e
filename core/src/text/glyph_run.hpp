// Glyphs of a run on their way to the band by band drawing.
#pragma once

#include <stdint.h>

#include "inkcell/painter.hpp"
#include "place/position.hpp"
#include "text/text_place.hpp"

namespace inkcell::detail {

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
