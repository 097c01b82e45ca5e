// Icons and emoji of several colours, from fonts that were made with
// inkcell-fontgen --colour.
//
//   port::Rgb565Canvas canvas(strip, kInk);
//   ColourGlyphs colours(port::colour_of(canvas));  // inkcell/port/colour.hpp
//   Painter(canvas, ram, &colours).text(font, style, pen, "sun \u2600");
//
// A glyph is then a list of layers, drawn one over the other: each is a glyph
// of the font in a colour of a palette, or in that of the text. All that a
// painter draws has them: text, boxes, labels, spans, values. A painter
// without ColourGlyphs draws the glyph's form of one colour.
#pragma once

#include <stdint.h>

#include "inkcell/canvas_colour.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"
#include "inkcell/storage.hpp"

namespace inkcell {

class ColourCache;

namespace detail {
class ColourPictures;
class LayerTable;
struct LayerCall;
}  // namespace detail

/// For a Painter, in the place of a cache: draws layers in their colours, and
/// other glyphs as ever. Each glyph ends with the canvas in the colour that it
/// found. Canvases of 1 and 2 bits, whose sinks have levels, show the form of
/// one colour. An effect draws each layer by itself. For one task at a time.
class ColourGlyphs : public detail::GlyphDrawer {
 public:
  /// The painter's sink draws into that canvas, maybe through other sinks.
  /// `cache`, which must outlive it, is a GlyphCache, which keeps layers as it
  /// keeps glyphs, or null.
  explicit ColourGlyphs(const CanvasColour& canvas,
                        const detail::GlyphDrawer* cache = nullptr) noexcept
      : GlyphDrawer{draw_layers,
                    cache == nullptr ? uint8_t{0} : cache->phase_shift},
        canvas_(canvas),
        glyphs_(cache == nullptr ? &detail::kDrawPlain : cache) {}

  /// Takes a palette of the font; beyond the last one, that one. 0 at first.
  ColourGlyphs& set_palette(uint8_t number) noexcept {
    palette_ = number;
    return *this;
  }
  /// Replaces the first colours of the palette, such as for a dark theme.
  /// inkcell-inspect prints those of a font. `colours` must outlive it.
  ColourGlyphs& set_colours(Span<const LayerColour> colours) noexcept {
    colours_ = colours;
    return *this;
  }

  /// Draws layers of a font in storage, too: StoredFont::layers(), which must
  /// outlive it. Without them its glyphs have one colour.
  ColourGlyphs& set_stored(const StoredLayers& layers) noexcept {
    stored_ = &layers;
    return *this;
  }
  ColourGlyphs& set_stored(const StoredLayers&&) = delete;

  /// Keeps glyphs of several colours as pictures (colour_cache.hpp). `cache`
  /// must outlive it.
  ColourGlyphs& set_cache(ColourCache& cache) noexcept;

 private:
  friend class detail::ColourPictures;

  LayerColour colour_of(const detail::LayerTable& table,
                        uint16_t number) const noexcept;
  static void draw_layers(detail::GlyphRun& run,
                          uint16_t glyph,
                          const detail::Placed& placed) noexcept;

  CanvasColour canvas_;
  const detail::GlyphDrawer* glyphs_;
  Span<const LayerColour> colours_;
  const StoredLayers* stored_ = nullptr;
  ColourCache* pictures_ = nullptr;
  // False: nothing was drawn.
  bool (*draw_picture_)(const detail::LayerCall& call) noexcept = nullptr;
  uint8_t palette_ = 0;
};

}  // namespace inkcell
