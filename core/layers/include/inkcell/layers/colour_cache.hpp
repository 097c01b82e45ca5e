// A cache of glyphs of several colours, as pictures in RAM that the caller
// lends.
//
// A GlyphCache keeps each layer, and draws all of them again. A picture is
// drawn at once, its pixels mixed already, in a fifth of the time.
//
//   alignas(4) static uint8_t ram[8192];  // five emoji of 24 px
//   ColourCache cache;
//   INKCELL_TRY(ColourCache::make(ram, cache));
//   ColourGlyphs colours(port::pictures_of(canvas));
//   colours.set_cache(cache);
//
// Pictures are those of one font, style and palette: another one empties the
// cache. Sizes that alternate want a cache each.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/canvas_colour.hpp"
#include "inkcell/cpp17.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/span.hpp"
#include "inkcell/status.hpp"
#include "inkcell/style.hpp"

namespace inkcell {

namespace detail {
class ColourPictures;
}

/// What a colour cache has done since it was made, and what it holds.
struct ColourCacheStats {
  uint32_t hits = 0;
  uint32_t misses = 0;    // drawn, and kept
  uint32_t bypasses = 0;  // drawn layer by layer, as the RAM is too small
  uint32_t glyphs = 0;    // that it holds
  uint32_t bytes = 0;     // that are in use
};

/// For ColourGlyphs that are made of port::pictures_of() a canvas of RGB565:
/// draws each glyph's layers once, at the nearest quarter of a pixel. Channels
/// of a picture differ by at most 2 levels from layers that are drawn one over
/// the other. The picture is the same whatever the cache holds.
///
/// Drawn by their layers, as without it: glyphs with a layer in the colour of
/// the text, styles with an effect, and sinks that are not the canvas's own,
/// such as those that fade. For one task at a time.
class ColourCache {
 public:
  /// Keeps nothing.
  constexpr ColourCache() noexcept = default;

  /// A cache in `ram`, whose data is a multiple of 4; it must outlive the
  /// cache. While a picture of w x h px is made it takes up to 7 w h bytes
  /// beside those that are kept, 2 w h or so each.
  ///
  /// misaligned: `ram` is. buffer_small: less than kMinBytes. `out` is
  /// untouched unless the result is ok.
  static Status make(Span<uint8_t> ram, ColourCache& out) noexcept;

  static constexpr size_t kMinBytes = 512;

  /// Forgets all pictures, as when colours of set_colours() change in place.
  /// Counters stay.
  void clear() noexcept { used_ = 0; }

  ColourCacheStats stats() const noexcept;

 private:
  friend class detail::ColourPictures;

  uint8_t* data_ = nullptr;
  uint32_t size_ = 0;
  uint32_t used_ = 0;  // [bytes]
  uint32_t clock_ = 0;
  uint32_t hits_ = 0;
  uint32_t misses_ = 0;
  uint32_t bypasses_ = 0;
  // What the pictures are of.
  const uint8_t* rom_ = nullptr;
  const LayerColour* colours_ = nullptr;
  size_t colour_count_ = 0;
  Style style_;
  uint8_t palette_ = 0;
};

}  // namespace inkcell
