// The painter: draws text and glyphs into a sink, and says which pixels they
// touch.
//
//   Painter painter(canvas, ram);
//   painter.text(font, style, pen, "Hello, 12:34");
//   const Rect dirty = painter.box(font, style, pen, "12:34");
//
// Positions are where the origin of a line lies: the left end of its baseline.
// Lines run along the style's direction.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell {

class Painter;
struct ShapedRun;

namespace detail {
struct GlyphDrawer;
struct Placed;

// Glyphs of one font and style, one after the other.
struct GlyphRun {
  const Painter& painter;
  const Font* font;
  const Style* style;
  uint32_t state = 0;  // of the drawer's own; 0 before the first glyph
};

// Draws the glyphs of a painter.
struct GlyphDrawer {
  void (*draw)(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept;
  // Draws them at multiples of that, to the nearest. [px, Q10, as a power of 2]
  uint8_t phase_shift;
};

// From the font, where they stand.
extern const GlyphDrawer kDrawPlain;

// Has no pixels.
extern const Sink kNoSink;
}  // namespace detail

/// Draws into a sink, with RAM that is lent and glyphs that a cache keeps, if
/// there are any: the picture is the same for any RAM. Holds pointers, and is
/// as cheap to make as to keep. The sink, the RAM and the cache must outlive
/// it. For one task at a time.
///
/// On canvases of 1 and 2 bits text() and box() of a text fit it to the grid of
/// pixels if its style leaves that open (few_levels.hpp); what is laid out
/// keeps its advances.
///
/// Drawing cannot fail: it clips, and glyphs that the font lacks are left out.
/// A style that Font::check() refuses draws nothing; where INKCELL_ASSERT is
/// compiled, it ends the program.
class Painter {
 public:
  /// Draws nothing: for boxes.
  Painter() noexcept : Painter(detail::kNoSink) {}

  /// `cache` is a GlyphCache (inkcell/cache/glyph_cache.hpp) or null.
  Painter(const Sink& sink,
          Workspace ram = {},
          const detail::GlyphDrawer* cache = nullptr) noexcept
      : sink_(&sink),
        ram_(ram),
        drawer_(cache == nullptr ? &detail::kDrawPlain : cache) {}

  /// Lays out and draws one line, with the advances of the style. For a screen
  /// drawn in many strips, `lay_out` once and `glyphs` for each is faster.
  void text(const Font& font,
            const Style& style,
            Point origin,
            Text text) const noexcept;

  /// The same of a line that was shaped when the program was built
  /// (shaped_run.hpp).
  void text(const Font& font,
            const Style& style,
            Point origin,
            const ShapedRun& run) const noexcept;

  /// Draws glyphs that were laid out. Positions are clamped to +-2^24 font
  /// units. Glyphs outside the sink's window cost little.
  void glyphs(const Font& font,
              const Style& style,
              Point origin,
              Span<const PositionedGlyph> glyphs) const noexcept {
    this->glyphs(Face{&font, &style}, {}, origin, glyphs);
  }

  /// The same for runs of several fonts. Positions are in units of `face`,
  /// along the direction of its style; `fallback` has the faces of other
  /// glyphs, of any size. Glyphs of faces beyond its end are left out.
  void glyphs(const Face& face,
              Span<const Face> fallback,
              Point origin,
              Span<const PositionedGlyph> glyphs) const noexcept;

  /// Draws one glyph by its id.
  void glyph(const Font& font,
             const Style& style,
             Point origin,
             uint16_t glyph) const noexcept;

  /// The pixels that a call of text() or glyphs() with these arguments may
  /// touch, with filter, grid fitting, effect and cache, whatever the window
  /// is. At most 2 px on each side stay empty, of turned text as many as the
  /// corners of its glyphs' boxes. Empty if nothing shows.
  Rect box(const Font& font,
           const Style& style,
           Point origin,
           Text text) const noexcept;
  Rect box(const Font& font,
           const Style& style,
           Point origin,
           const ShapedRun& run) const noexcept;
  Rect box(const Font& font,
           const Style& style,
           Point origin,
           Span<const PositionedGlyph> glyphs) const noexcept {
    return box(Face{&font, &style}, {}, origin, glyphs);
  }
  Rect box(const Face& face,
           Span<const Face> fallback,
           Point origin,
           Span<const PositionedGlyph> glyphs) const noexcept;

  /// The same of one glyph.
  Rect glyph_box(const Font& font,
                 const Style& style,
                 Point origin,
                 uint16_t glyph) const noexcept;

  /// Width and ink of a line in px, with the advances that text() takes.
  PixelMeasure measure(const Font& font,
                       const Style& style,
                       Text text) const noexcept;

  const Sink& sink() const noexcept { return *sink_; }
  const Workspace& ram() const noexcept { return ram_; }
  const detail::GlyphDrawer& drawer() const noexcept { return *drawer_; }

  /// What a style is drawn with here: Sink::adapt.
  const Style& adapted(const Style& style,
                       bool is_laid_out,
                       Style& room) const noexcept {
    return sink_->adapt == nullptr ? style
                                   : sink_->adapt(style, is_laid_out, room);
  }

 private:
  const Sink* sink_;
  Workspace ram_;
  const detail::GlyphDrawer* drawer_;
};

}  // namespace inkcell
