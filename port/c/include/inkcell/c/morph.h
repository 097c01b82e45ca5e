// Glyphs that turn into others, as in inkcell/motion/outline_morph.hpp.
// Progress is from 0 to 1 and clamped. [Q16]
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/draw.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A pair of glyphs of a font, which must outlive it. Opaque. Empty, it draws
/// nothing.
typedef struct INKCELL_SHARED inkcell_outline_morph_t {
  const void* words[3];
  uint16_t glyphs[2];
} inkcell_outline_morph_t;

/// NO_GLYPH: the font does not hold the pair (inkcell-fontgen --morph). A glyph
/// and itself always are one.
inkcell_status_t inkcell_outline_morph_open(const inkcell_font_t* font,
                                            uint16_t from,
                                            uint16_t to,
                                            inkcell_outline_morph_t* out);

/// From a glyph to its second master: bolder, wider or slanted. NO_GLYPH: the
/// font holds none (inkcell-fontgen --axis wght=300..800).
inkcell_status_t inkcell_outline_morph_open_master(
    const inkcell_font_t* font, uint16_t glyph, inkcell_outline_morph_t* out);

/// Between the advances of both glyphs. [px, Q6]
int32_t inkcell_outline_morph_advance(const inkcell_outline_morph_t* morph,
                                      const inkcell_style_t* style,
                                      int32_t progress_q16);

/// The least workspace for inkcell_outline_morph_draw(). [bytes]
size_t inkcell_outline_morph_workspace_bytes(const inkcell_font_t* font);

/// Draws the glyph with its origin at (x_q6, y_q6); nothing between the ends if
/// the painter's RAM is too small.
void inkcell_outline_morph_draw(const inkcell_outline_morph_t* morph,
                                const inkcell_painter_t* painter,
                                const inkcell_style_t* style,
                                int32_t x_q6,
                                int32_t y_q6,
                                int32_t progress_q16);

/// The pixels that it may touch.
void inkcell_outline_morph_box(const inkcell_outline_morph_t* morph,
                               const inkcell_style_t* style,
                               int32_t x_q6,
                               int32_t y_q6,
                               int32_t progress_q16,
                               inkcell_rect_t* out);

/// Progress that begins and ends slowly.
int32_t inkcell_ease_in_out(int32_t progress_q16);

#ifdef __cplusplus
}
#endif
