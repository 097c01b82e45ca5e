// Caches of drawn glyphs.
#include "inkcell/c/cache.h"

#include "inkcell/cache/glyph_cache.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;
using c::point_of;
using c::workspace_of;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_glyph_cache_t> {
  using Type = GlyphCache;
};
template <>
struct CppOf<inkcell_glyph_cache_stats_t> {
  using Type = GlyphCacheStats;
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_PLACE(inkcell_glyph_cache_stats_t, hits, hits);
INKCELL_SAME_PLACE(inkcell_glyph_cache_stats_t, misses, misses);
INKCELL_SAME_PLACE(inkcell_glyph_cache_stats_t, bypasses, bypasses);
INKCELL_SAME_PLACE(inkcell_glyph_cache_stats_t, evictions, evictions);
INKCELL_SAME_PLACE(inkcell_glyph_cache_stats_t, glyphs, glyphs);
INKCELL_SAME_PLACE(inkcell_glyph_cache_stats_t, bytes, bytes);
INKCELL_SAME_PLACE(inkcell_glyph_cache_stats_t, capacity, capacity);

namespace {

uint8_t value_or(uint8_t value, uint8_t otherwise) noexcept {
  return value == 0 ? otherwise : value;
}

}  // namespace

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
  *cpp(out) = GlyphCache();
  return c::code(
      GlyphCache::make({static_cast<uint8_t*>(ram), size}, same, *cpp(out)));
}

void inkcell_glyph_cache_draw_text(inkcell_glyph_cache_t* cache,
                                   const inkcell_font_t* font,
                                   const char* text,
                                   size_t size,
                                   const inkcell_style_t* style,
                                   int32_t x_q6,
                                   int32_t y_q6,
                                   const inkcell_sink_t* sink,
                                   const inkcell_workspace_t* ram) {
  Painter(*cpp(sink), workspace_of(ram), cpp(cache))
      .text(*cpp(font), *cpp(style), point_of(x_q6, y_q6),
            c::text_of(text, size));
}

void inkcell_glyph_cache_draw_run(inkcell_glyph_cache_t* cache,
                                  const inkcell_font_t* font,
                                  const inkcell_positioned_glyph_t* glyphs,
                                  size_t count,
                                  const inkcell_style_t* style,
                                  int32_t x_q6,
                                  int32_t y_q6,
                                  const inkcell_sink_t* sink,
                                  const inkcell_workspace_t* ram) {
  Painter(*cpp(sink), workspace_of(ram), cpp(cache))
      .glyphs(*cpp(font), *cpp(style), point_of(x_q6, y_q6),
              {cpp(glyphs), count});
}

void inkcell_glyph_cache_draw_faces(inkcell_glyph_cache_t* cache,
                                    const inkcell_face_t* face,
                                    const inkcell_face_t* fallback,
                                    size_t fallback_count,
                                    const inkcell_positioned_glyph_t* glyphs,
                                    size_t count,
                                    int32_t x_q6,
                                    int32_t y_q6,
                                    const inkcell_sink_t* sink,
                                    const inkcell_workspace_t* ram) {
  Painter(*cpp(sink), workspace_of(ram), cpp(cache))
      .glyphs(*cpp(face), {cpp(fallback), fallback_count}, point_of(x_q6, y_q6),
              {cpp(glyphs), count});
}

void inkcell_glyph_cache_clear(inkcell_glyph_cache_t* cache) {
  cpp(cache)->clear();
}

void inkcell_glyph_cache_stats(const inkcell_glyph_cache_t* cache,
                               inkcell_glyph_cache_stats_t* out) {
  *cpp(out) = cpp(cache)->stats();
}
