// A shaped string, drawn by a program of C.
#pragma once

#include "inkcell/c/shaped_run.h"

#ifdef __cplusplus
extern "C" {
#endif

void draw_greeting(const inkcell_font_t* font,
                   const inkcell_style_t* style,
                   const inkcell_sink_t* sink);

/// The font that has the string.
inkcell_status_t open_greeting_font(inkcell_font_t* out);

/// Its glyphs and its ink, of a style, and BUFFER_SMALL for room
/// that is too small.
inkcell_status_t measure_greeting(const inkcell_font_t* font,
                                  const inkcell_style_t* style,
                                  inkcell_positioned_glyph_t* out,
                                  size_t capacity,
                                  size_t* count,
                                  inkcell_pixel_measure_t* measure);

#ifdef __cplusplus
}
#endif
