// Lines that were shaped when the program was built, as in
// inkcell/shaped_run.hpp. `inkcell-fontgen --strings` makes them, in ROM beside
// their font; docs/STRINGS.md says how.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/draw.h"
#include "inkcell/c/font.h"
#include "inkcell/c/sink.h"
#include "inkcell/c/style.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A glyph of a shaped run. Font units, y up.
typedef struct INKCELL_SHARED inkcell_shaped_glyph_t {
  uint16_t glyph;  // id in the font that was made with the run
  int16_t x;       // from the glyph before it; from the run's origin first
  int16_t y;       // from the baseline
} inkcell_shaped_glyph_t;

/// A line of glyphs from left to right, without those that show nothing. Any
/// numbers are safe: glyphs that the font lacks are left out.
typedef struct INKCELL_SHARED inkcell_shaped_run_t {
  const inkcell_shaped_glyph_t* glyphs;  // may be null where count is 0
  size_t count;
  int32_t advance;  // as designed [font units]; inkcell_to_px() gives px
} inkcell_shaped_run_t;

/// Positions of all glyphs of a run, into `out`, which has room for `capacity`.
/// `count` glyphs are there.
///
/// BUFFER_SMALL: the run has more than `capacity`; `count` is then 0.
inkcell_status_t inkcell_lay_out_shaped(const inkcell_painter_t* painter,
                                        const inkcell_font_t* font,
                                        const inkcell_shaped_run_t* run,
                                        const inkcell_style_t* style,
                                        inkcell_positioned_glyph_t* out,
                                        size_t capacity,
                                        size_t* count);

/// Width and ink of a run.
void inkcell_measure_shaped(const inkcell_painter_t* painter,
                            const inkcell_font_t* font,
                            const inkcell_shaped_run_t* run,
                            const inkcell_style_t* style,
                            inkcell_pixel_measure_t* out);

/// Draws a run with the left end of its baseline at (x_q6, y_q6).
void inkcell_draw_shaped(const inkcell_painter_t* painter,
                         const inkcell_font_t* font,
                         const inkcell_shaped_run_t* run,
                         const inkcell_style_t* style,
                         int32_t x_q6,
                         int32_t y_q6);

#ifdef __cplusplus
}
#endif
