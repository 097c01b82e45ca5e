// From text and runs to glyphs, each drawn where it stands.
#include "inkcell/painter.hpp"

#include "base/math.hpp"
#include "inkcell/assert.hpp"
#include "rows/draw_bands.hpp"
#include "text/glyph_run.hpp"
#include "text/text_place.hpp"

namespace inkcell {
namespace detail {

void draw_plain(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept {
  const Font& font = *run.font;
  INKCELL_ASSERT(font.check(*run.style) == Status::ok);
  if (font.source() != nullptr) {
    draw_bands({font.source(), &font, glyph}, *run.style, placed,
               run.painter.sink(), run.painter.ram());
  }
}

const GlyphDrawer kDrawPlain = {draw_plain, 0};
const Sink kNoSink = {};

Rect box_of(const GlyphRun& run,
            uint16_t glyph,
            const Placed& placed) noexcept {
  const Font& font = *run.font;
  return font.source() == nullptr
             ? Rect{}
             : band_box({font.source(), &font, glyph}, *run.style,
                        at_phase(placed, run.painter.drawer().phase_shift));
}

namespace {

// Draws nothing, but adds up the boxes of glyphs.
struct BoxDrawer : GlyphDrawer {
  Rect* sum;

  BoxDrawer(const GlyphDrawer& drawer, Rect& boxes) noexcept
      : GlyphDrawer{add, drawer.phase_shift}, sum(&boxes) {}

  static void add(GlyphRun& run,
                  uint16_t glyph,
                  const Placed& placed) noexcept {
    Rect& sum = *static_cast<const BoxDrawer&>(run.painter.drawer()).sum;
    sum = bounding_box(sum, box_of(run, glyph, placed));
  }
};

}  // namespace
}  // namespace detail

using detail::BoxDrawer;
using detail::GlyphRun;
using detail::place_near;
using detail::Placed;
using detail::run_origin;
using detail::UnitScale;

Status Font::check(const Style& style) const noexcept {
  return source_ == nullptr || detail::can_draw(*source_, style)
             ? Status::ok
             : Status::unsupported;
}

void Painter::text(const Font& font,
                   const Style& given,
                   Point origin,
                   Text text) const noexcept {
  detail::StyleRoom room;
  const Style& style = adapted(given, false, room.style());
  const UnitScale scale(font, style);
  TextCursor cursor(font, text, style);
  if (cursor.is_in_whole_px()) {
    origin.x = detail::whole_px(origin.x);
  }
  GlyphRun run = {*this, &font, &style};
  PositionedGlyph at;
  Placed placed;
  while (cursor.next(at)) {
    if (place_near(scale, style, origin, at, placed)) {
      drawer_->draw(run, at.glyph, placed);
    }
  }
}

void Painter::glyphs(const Face& face,
                     Span<const Face> fallback,
                     Point origin,
                     Span<const PositionedGlyph> glyphs) const noexcept {
  INKCELL_ASSERT(face.font != nullptr && face.style != nullptr);
  const UnitScale scale(*face.font, *face.style);
  origin = run_origin(*face.style, origin);
  detail::StyleRoom room;
  GlyphRun run = {*this, face.font, &adapted(*face.style, true, room.style())};
  uint32_t drawn_face = 0;
  Placed placed;
  for (const PositionedGlyph& at : glyphs) {
    if (at.face > fallback.size) {
      continue;
    }
    if (at.face != drawn_face) {
      const Face& own = at.face == 0 ? face : fallback[at.face - 1u];
      INKCELL_ASSERT(own.font != nullptr && own.style != nullptr);
      drawn_face = at.face;
      run.font = own.font;
      run.style = &adapted(*own.style, true, room.style());
      run.state = 0;
    }
    if (place_near(scale, *face.style, origin, at, placed)) {
      drawer_->draw(run, at.glyph, placed);
    }
  }
}

void Painter::glyph(const Font& font,
                    const Style& given,
                    Point origin,
                    uint16_t glyph) const noexcept {
  detail::StyleRoom room;
  const Style& style = adapted(given, false, room.style());
  Placed placed;
  if (placed.set(origin)) {
    GlyphRun run = {*this, &font, &style};
    drawer_->draw(run, glyph, placed);
  }
}

Rect Painter::box(const Font& font,
                  const Style& style,
                  Point origin,
                  Text text) const noexcept {
  Rect sum;
  const BoxDrawer boxes(*drawer_, sum);
  Painter(*sink_, {}, &boxes).text(font, style, origin, text);
  return sum;
}

Rect Painter::box(const Font& font,
                  const Style& style,
                  Point origin,
                  const ShapedRun& run) const noexcept {
  Rect sum;
  const BoxDrawer boxes(*drawer_, sum);
  Painter(*sink_, {}, &boxes).text(font, style, origin, run);
  return sum;
}

Rect Painter::box(const Face& face,
                  Span<const Face> fallback,
                  Point origin,
                  Span<const PositionedGlyph> glyphs) const noexcept {
  Rect sum;
  const BoxDrawer boxes(*drawer_, sum);
  Painter(*sink_, {}, &boxes).glyphs(face, fallback, origin, glyphs);
  return sum;
}

PixelMeasure Painter::measure(const Font& font,
                              const Style& given,
                              Text text) const noexcept {
  detail::StyleRoom room;
  const Style& style = adapted(given, false, room.style());
  return to_px(font, style, inkcell::measure(font, text, style));
}

Rect Painter::glyph_box(const Font& font,
                        const Style& given,
                        Point origin,
                        uint16_t glyph) const noexcept {
  detail::StyleRoom room;
  const Style& style = adapted(given, false, room.style());
  Placed placed;
  return placed.set(origin)
             ? detail::box_of({*this, &font, &style}, glyph, placed)
             : Rect{};
}

}  // namespace inkcell
