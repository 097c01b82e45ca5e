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

void inkcell_glyph_cache_draw_text(inkcell_glyph_cache_t* cache,
                                   const inkcell_font_t* font,
                                   const char* text,
                                   size_t size,
                                   const inkcell_style_t* style,
                                   int32_t x_q6,
                                   int32_t y_q6,
                                   const inkcell_sink_t* sink,
                                   const inkcell_workspace_t* ram) {
  Painter(ref(sink), workspace_of(ram), cpp(cache)).text(ref(font), ref(style),
      point_of(x_q6, y_q6), text_of(text, size));
}

void inkcell_glyph_cache_draw_glyphs(inkcell_glyph_cache_t* cache,
                                     const inkcell_font_t* font,
                                     const inkcell_positioned_glyph_t* glyphs,
                                     size_t count,
                                     const inkcell_style_t* style,
                                     int32_t x_q6,
                                     int32_t y_q6,
                                     const inkcell_sink_t* sink,
                                     const inkcell_workspace_t* ram) {
  Painter(ref(sink), workspace_of(ram), cpp(cache)).glyphs(ref(font),
      ref(style), point_of(x_q6, y_q6), {cpp(glyphs), count});
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
  Painter(ref(sink), workspace_of(ram), cpp(cache)).glyphs(ref(face),
      {cpp(fallback), fallback_count}, point_of(x_q6, y_q6), {cpp(glyphs),
      count});
}

void inkcell_glyph_cache_clear(inkcell_glyph_cache_t* cache) {
  ref(cache).clear();
}

void inkcell_glyph_cache_stats(const inkcell_glyph_cache_t* cache,
                               inkcell_glyph_cache_stats_t* out) {
  ref(out) = ref(cache).stats();
}
