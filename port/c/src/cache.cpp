// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_glyph_cache_make(
    void* ram,
    size_t size,
    const inkcell_glyph_cache_options_t* options,
    inkcell_glyph_cache_t* out) {
  GlyphCacheOptions same;
  if (options != nullptr) {
    same.bits = value_or(options->bits, same.bits);
    same.phases = value_or(options->phases, same.phases);
    same.styles = value_or(options->styles, same.styles);
  }
  ref(out) = GlyphCache();
  return code(GlyphCache::make({static_cast<uint8_t*>(ram), size}, same,
      ref(out)));
}

void inkcell_glyph_cache_clear(inkcell_glyph_cache_t* cache) {
  ref(cache).clear();
}

void inkcell_glyph_cache_stats(const inkcell_glyph_cache_t* cache,
                               inkcell_glyph_cache_stats_t* out) {
  ref(out) = ref(cache).stats();
}
