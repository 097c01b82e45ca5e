// A cache of drawn glyphs, in RAM that the caller lends.
//
// Labels, lists and clocks draw the same few glyphs again and again. A glyph
// that the cache holds is drawn without its outline, at 12 to 16 px in a
// quarter of the time.
//
//   alignas(8) static uint8_t ram[2048];  // ten digits of 32 px
//   GlyphCache cache;
//   INKCELL_TRY(GlyphCache::make(ram, {}, cache));
//   cache.draw_text(font, "12:34", style, origin, sink);
//
// Coverage is kept, not colour: any sink draws it, in strips, too. Glyphs that
// were not drawn for the longest time make room for new ones.
#pragma once

#include <stdint.h>

#include "inkcell/font.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"
#include "inkcell/workspace.hpp"

namespace inkcell {

namespace detail {
class GlyphStore;
}

struct GlyphCacheOptions {
  /// Bits of a stored coverage: 4 (errors up to 8/255) or 8 (exact).
  uint8_t bits = 4;
  /// Places within a pixel at which glyphs are kept, across and down: a power
  /// of 2 from 1 to 64. Glyphs are drawn at the nearest of these.
  uint8_t phases = 4;
  /// Pairs of a font and a style that are kept at once, 1 to 16. [about 150
  /// bytes each]
  uint8_t styles = 1;
};

/// What a cache has done since it was made, and what it holds.
struct GlyphCacheStats {
  uint32_t hits = 0;
  uint32_t misses = 0;     // drawn, and kept
  uint32_t bypasses = 0;   // drawn, too large to be kept
  uint32_t evictions = 0;  // glyphs that made room for others
  uint32_t glyphs = 0;     // that it holds
  uint32_t bytes = 0;      // that are in use
  uint32_t capacity = 0;   // bytes that it was lent
};

/// Draws runs as draw() and draw_text() do, but each glyph only once. The same
/// calls make the same picture with every cache, whatever it holds.
///
/// Styles are compared by value; the filter, fitter and effect that they name,
/// and fonts, by address. Call clear() before one of these changes. For one
/// task at a time.
class GlyphCache {
 public:
  /// Keeps nothing: every glyph is drawn anew.
  constexpr GlyphCache() noexcept = default;

  /// A cache in `ram`, whose data is a multiple of the size of a pointer. Of
  /// more than 65,535 bytes the rest is not used. It must outlive the cache.
  ///
  /// bad_argument: an option is outside its range. misaligned: `ram` is.
  /// buffer_small: less than kMinBytes for each style. `out` is untouched
  /// unless the result is ok.
  static Status make(Span<uint8_t> ram,
                     const GlyphCacheOptions& options,
                     GlyphCache& out) noexcept;

  /// The least RAM, for each style.
  static constexpr size_t kMinBytes = 512;

  /// As the function of that name in text.hpp, with each glyph at the nearest
  /// phase. `workspace` is lent for glyphs that the cache does not hold yet.
  void draw(const Font& font,
            Span<const PositionedGlyph> glyphs,
            const Style& style,
            Point origin,
            const Sink& sink,
            Workspace workspace = {}) noexcept;

  /// The same with glyphs of other faces. Each takes a slot of its own.
  void draw(const Face& face,
            Span<const Face> fallback,
            Span<const PositionedGlyph> glyphs,
            Point origin,
            const Sink& sink,
            Workspace workspace = {}) noexcept;

  void draw_text(const Font& font,
                 Text text,
                 const Style& style,
                 Point origin,
                 const Sink& sink,
                 Workspace workspace = {}) noexcept;

  /// Forgets all glyphs. Counters stay.
  void clear() noexcept;

  GlyphCacheStats stats() const noexcept;

 private:
  detail::GlyphStore* store_ = nullptr;  // in the lent RAM
};

}  // namespace inkcell
