// A cache of drawn glyphs, as in inkcell/cache/glyph_cache.hpp.
//
//   static uint64_t ram[256];  // ten digits of 32 px
//   inkcell_glyph_cache_t cache;
//   inkcell_glyph_cache_make(ram, sizeof ram, NULL, &cache);
//   const inkcell_painter_t painter = {.sink = &sink, .cache = &cache};
//
// Glyphs are drawn at the nearest place. Filters, fits, effects and fonts are
// compared by address: clear the cache before one changes.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/draw.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Opaque. Empty, it keeps nothing: every glyph is drawn anew. For one task at
/// a time.
typedef struct INKCELL_SHARED inkcell_glyph_cache_t {
  void* words[3];
} inkcell_glyph_cache_t;

/// 0 takes the default.
typedef struct inkcell_glyph_cache_options_t {
  uint8_t bits;    // of a coverage: 4, the default, or 8
  uint8_t phases;  // places within a pixel: a power of 2, 1 to 64; default 4
  uint8_t styles;  // pairs of a font and a style, 1 to 16; default 1
} inkcell_glyph_cache_options_t;

/// What a cache has done since it was made, and what it holds.
typedef struct INKCELL_SHARED inkcell_glyph_cache_stats_t {
  uint32_t hits;
  uint32_t misses;     // drawn, and kept
  uint32_t bypasses;   // drawn, too large to be kept
  uint32_t evictions;  // glyphs that made room for others
  uint32_t glyphs;     // that it holds
  uint32_t bytes;      // that are in use
  uint32_t capacity;   // bytes that it was lent
} inkcell_glyph_cache_stats_t;

/// A cache in `ram`, a multiple of the size of a pointer, of `size` bytes, at
/// least 512 for each style; of more than 65,535 the rest is not used. It must
/// outlive the cache. `options` may be null: defaults.
///
/// BAD_ARGUMENT: an option. MISALIGNED, BUFFER_SMALL: `ram`.
inkcell_status_t inkcell_glyph_cache_make(
    void* ram,
    size_t size,
    const inkcell_glyph_cache_options_t* options,
    inkcell_glyph_cache_t* out);

/// Forgets all glyphs. Counters stay.
void inkcell_glyph_cache_clear(inkcell_glyph_cache_t* cache);

void inkcell_glyph_cache_stats(const inkcell_glyph_cache_t* cache,
                               inkcell_glyph_cache_stats_t* out);

#ifdef __cplusplus
}
#endif
