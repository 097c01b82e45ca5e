// From text and runs to glyphs, each drawn where it stands.
#include "inkcell/painter.hpp"

#include "base/math.hpp"
#include "inkcell/assert.hpp"
#include "rows/source.hpp"
#include "rows/strike_scale.hpp"
#include "text/glyph_run.hpp"

namespace inkcell {
namespace detail {

void draw_plain(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept {
  const Source* const source = run.font->source();
  if (source != nullptr) {
    source->draw(run, glyph, placed);
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
             : band_box({{font.source(), &font, glyph},
                         *run.style,
                         at_phase(placed, run.painter.drawer().phase_shift),
                         nullptr});
}

void BoxDrawer::add(GlyphRun& run,
                    uint16_t glyph,
                    const Placed& placed) noexcept {
  // The painter that has it was made with the object itself.
  auto& self = const_cast<BoxDrawer&>(
      static_cast<const BoxDrawer&>(run.painter.drawer()));
  self.sum = bounding_box(self.sum, box_of(run, glyph, placed));
}

}  // namespace detail

using detail::BoxDrawer;
using detail::FacesDrawer;
using detail::GlyphRun;
using detail::Placed;
using detail::RunDrawer;

// Whether bands of a style hold exact areas.
static bool fills_areas(const Style& style) noexcept {
  const Effect* const effect = style.effect();
  const detail::BandKind* const kind =
      effect != nullptr && effect->mixer().band_kind != nullptr
          ? effect->mixer().band_kind
          : detail::StyleParts::band_kind(style);
  return kind != nullptr && kind->bytes == detail::BandBytes::area;
}

Status Font::check(const Style& style) const noexcept {
  if (source_ == nullptr) {
    return Status::ok;
  }
  const bool draws =
      source_->kind == detail::SourceKind::strikes
          ? detail::strike_scale(*this, style) != 0 && style.effect() == nullptr
          : detail::can_draw(*source_, style) &&
                (source_->kind != detail::SourceKind::areas ||
                 fills_areas(style));
  return draws ? Status::ok : Status::unsupported;
}

void Painter::text(const Font& font,
                   const Style& style,
                   Point origin,
                   Text text) const noexcept {
  RunDrawer drawer(*this, font, style);
  TextCursor cursor(*this, font, text, drawer.style());
  drawer.draw_line(origin, cursor);
}

void Painter::glyphs(const Face& face,
                     Span<const Face> fallback,
                     Point origin,
                     Span<const PositionedGlyph> glyphs) const noexcept {
  INKCELL_ASSERT(face.font != nullptr && face.style != nullptr);
  FacesDrawer drawer(*this, face, fallback);
  drawer.begin(origin, drawer.style().has_whole_advances());
  for (const PositionedGlyph& at : glyphs) {
    drawer.draw(at);
  }
}

void Painter::glyph(const Font& font,
                    const Style& given,
                    Point origin,
                    uint16_t glyph) const noexcept {
  detail::StyleRoom room;
  const Style& style = adapted(given, room.style());
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
  BoxDrawer boxes(*this);
  with(boxes).text(font, style, origin, text);
  return boxes.sum;
}

Rect Painter::box(const Font& font,
                  const Style& style,
                  Point origin,
                  const ShapedRun& run) const noexcept {
  BoxDrawer boxes(*this);
  with(boxes).text(font, style, origin, run);
  return boxes.sum;
}

Rect Painter::box(const Face& face,
                  Span<const Face> fallback,
                  Point origin,
                  Span<const PositionedGlyph> glyphs) const noexcept {
  BoxDrawer boxes(*this);
  with(boxes).glyphs(face, fallback, origin, glyphs);
  return boxes.sum;
}

PixelMeasure Painter::measure(const Font& font,
                              const Style& style,
                              Text text) const noexcept {
  detail::StyleRoom room;
  return to_px(font, style,
               inkcell::measure(
                   font, {*this, font, text, adapted(style, room.style())}));
}

Status Painter::lay_out(const Font& font,
                        const Style& style,
                        Text text,
                        Span<PositionedGlyph> out,
                        Span<const PositionedGlyph>& glyphs) const noexcept {
  if (text.size > kMaxLineBytes) {
    return Status::bad_argument;
  }
  detail::StyleRoom room;
  TextCursor cursor(*this, font, text, adapted(style, room.style()));
  return detail::lay_out_line(cursor, out, glyphs);
}

Rect Painter::glyph_box(const Font& font,
                        const Style& given,
                        Point origin,
                        uint16_t glyph) const noexcept {
  detail::StyleRoom room;
  const Style& style = adapted(given, room.style());
  Placed placed;
  return placed.set(origin)
             ? detail::box_of({*this, &font, &style}, glyph, placed)
             : Rect{};
}

}  // namespace inkcell
