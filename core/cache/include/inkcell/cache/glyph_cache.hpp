// A cache of drawn glyphs, in RAM that the caller lends.
//
// Labels, lists and clocks draw the same few glyphs again and again. A glyph
// that the cache holds is drawn without its outline, at 12 to 16 px in a
// quarter of the time.
//
//   alignas(8) static uint8_t ram[2048];  // ten digits of 32 px
//   GlyphCache cache;
//   INKCELL_TRY(GlyphCache::make(ram, {}, cache));
//   Painter(sink, {}, &cache).text(font, style, origin, "12:34");
//
// Coverage is kept, not colour: any sink draws it, in strips, too. Glyphs that
// were not drawn for the longest time make room for new ones.
#pragma once

#include <stdint.h>

#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"

namespace inkcell {

namespace detail {
class GlyphStore;
}

/// How glyphs are stored, and which.
struct GlyphCacheOptions {
  /// Bits of a stored coverage: 4 (errors up to 8/255) or 8 (exact).
  uint8_t bits = 4;
  /// Places within a pixel at which glyphs are kept, across and down: a power
  /// of 2 from 1 to 64. Glyphs are drawn at the nearest of these.
  uint8_t phases = 4;
  /// Pairs of a font and a style that are kept at once, 1 to 16; of a run in
  /// several fonts each takes one. [about 150 bytes each]
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

/// For a Painter: draws each glyph only once, at the nearest phase. The same
/// calls make the same picture with every cache, whatever it holds. The
/// painter's RAM is lent for glyphs that the cache does not hold yet.
///
/// Styles are compared by value; the filter, fitter and effect that they name,
/// and fonts, by address. Call clear() before one of these changes. For one
/// task at a time.
class GlyphCache : public detail::GlyphDrawer {
 public:
  /// Keeps nothing: every glyph is drawn anew, where it stands.
  constexpr GlyphCache() noexcept : GlyphDrawer{draw_kept, 0} {}

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

  /// Forgets all glyphs. Counters stay.
  void clear() noexcept;

  GlyphCacheStats stats() const noexcept;

 private:
  static void draw_kept(detail::GlyphRun& run,
                        uint16_t glyph,
                        const detail::Placed& placed) noexcept;

  detail::GlyphStore* store_ = nullptr;  // in the lent RAM
};

}  // namespace inkcell
