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

#include "inkcell/few_levels.hpp"
#include "inkcell/font.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"
#include "inkcell/text_report.hpp"
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

/// The one door of text: a sink, RAM that is lent, a cache of glyphs and what
/// to do with missing characters, if there are any; the picture is the same for
/// any RAM. Whatever measures or draws text takes a painter. Holds pointers,
/// and is as cheap to make as to keep. What it points to must outlive it. For
/// one task at a time.
///
/// On canvases of 1 and 2 bits it fits text to the grid of pixels if the style
/// leaves that open (few_levels.hpp), in each call: what it measures and lays
/// out is what it draws.
///
/// Drawing cannot fail: it clips. A character that the font lacks is drawn as
/// .notdef, a box, unless a report says otherwise; ids beyond the font's last
/// glyph are left out. A style that Font::check() refuses draws nothing; where
/// INKCELL_ASSERT is compiled, it ends the program.
class Painter {
 public:
  /// Draws nothing: for boxes and measures where no canvas has 1 or 2 bits.
  Painter() noexcept : Painter(detail::kNoSink) {}

  /// `cache` is a GlyphCache (inkcell/cache/glyph_cache.hpp) or null; `report`
  /// says what to do with missing characters and tells how text went
  /// (text_report.hpp), or is null.
  Painter(const Sink& sink,
          Workspace ram = {},
          const detail::GlyphDrawer* cache = nullptr,
          TextReport* report = nullptr) noexcept
      : sink_(&sink),
        ram_(ram),
        drawer_(cache == nullptr ? &detail::kDrawPlain : cache),
        report_(report) {}

  /// The same for another sink, such as one of a smaller window.
  Painter with(const Sink& sink) const noexcept {
    Painter copy = *this;
    copy.sink_ = &sink;
    return copy;
  }
  /// The same with another cache.
  Painter with(const detail::GlyphDrawer& cache) const noexcept {
    Painter copy = *this;
    copy.drawer_ = &cache;
    return copy;
  }
  /// The same with text that is shaped: by a LineShaper
  /// (inkcell/layout/line_shaper.hpp), one for each task.
  Painter with(detail::LineSetter& lines) const noexcept {
    Painter copy = *this;
    copy.lines_ = &lines;
    return copy;
  }
  /// The same for type that moves: glyphs stay as designed, on any canvas,
  /// unless their style says otherwise.
  Painter for_motion() const noexcept {
    Painter copy = *this;
    copy.can_fit_ = false;
    return copy;
  }

  /// Lays out and draws one line. For a screen drawn in many strips, lay_out()
  /// once and glyphs() for each is faster.
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

  /// Width and ink of a line in px, with the advances that text() takes. The
  /// ink is that of glyphs as designed: fitting moves it by a pixel or so.
  PixelMeasure measure(const Font& font,
                       const Style& style,
                       Text text) const noexcept;
  PixelMeasure measure(const Font& font,
                       const Style& style,
                       const ShapedRun& run) const noexcept;

  /// Positions of all glyphs of a line, for glyphs() with the same style. Where
  /// text is fitted, letters stand on whole pixels, in font units to the
  /// nearest. `out` holds at most text.size glyphs, which always suffice;
  /// `glyphs` is the part of it that was filled.
  ///
  /// buffer_small: `out` was too short; bad_argument: the text is longer than
  /// kMaxLineBytes. `glyphs` is then untouched. A LineShaper may make a few
  /// glyphs more than there are bytes.
  Status lay_out(const Font& font,
                 const Style& style,
                 Text text,
                 Span<PositionedGlyph> out,
                 Span<const PositionedGlyph>& glyphs) const noexcept;
  /// The same of a shaped run, of run.glyphs.size glyphs. Where text is fitted,
  /// gaps are rounded to the nearest pixel, kerning towards 0. A glyph that
  /// begins before the middle of the advance of the letter to its left is a
  /// mark and keeps its place on the letter, to the nearest pixel.
  Status lay_out(const Font& font,
                 const Style& style,
                 const ShapedRun& run,
                 Span<PositionedGlyph> out,
                 Span<const PositionedGlyph>& glyphs) const noexcept;

  const Sink& sink() const noexcept { return *sink_; }
  const Workspace& ram() const noexcept { return ram_; }
  const detail::GlyphDrawer& drawer() const noexcept { return *drawer_; }
  TextReport* report() const noexcept { return report_; }
  detail::LineSetter* line_setter() const noexcept { return lines_; }

  /// What a style is drawn with here, made in `room` where it differs.
  const Style& adapted(const Style& style, Style& room) const noexcept {
    const detail::LevelRule* const rule = sink_->levels;
    return rule == nullptr ? style : rule->adapt(*rule, style, can_fit_, room);
  }
  /// Its fitter alone.
  const Fitter* fitter_of(const Style& style) const noexcept {
    const detail::LevelRule* const rule = sink_->levels;
    return rule == nullptr ? style.fitter()
                           : rule->fitter(*rule, style, can_fit_);
  }

 private:
  const Sink* sink_;
  Workspace ram_;
  const detail::GlyphDrawer* drawer_;
  TextReport* report_;
  detail::LineSetter* lines_ = nullptr;
  bool can_fit_ = true;
};

}  // namespace inkcell
