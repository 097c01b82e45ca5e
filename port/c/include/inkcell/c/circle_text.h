// Lines of text on a circle, as in inkcell/motion/path.hpp.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/draw.h"
#include "inkcell/c/types.h"
#include "inkcell/c/value.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Outside lines run clockwise, for the upper half of a dial; inside ones have
/// their heads to the centre, for the lower half.
enum { INKCELL_CIRCLE_OUTSIDE = 0, INKCELL_CIRCLE_INSIDE = 1 };

/// The circle of a line's baseline.
typedef struct INKCELL_SHARED inkcell_text_circle_t {
  int32_t x_q6;  // of the centre
  int32_t y_q6;
  int32_t radius_q6;  // clamped to 1..8191 px
  uint16_t at;        // of the anchor, from the right [1/65536 turn]
  uint8_t side;
  uint8_t anchor;  // INKCELL_ANCHOR_CENTRE and others
} inkcell_text_circle_t;

/// Draws a line with the size, the filter and the effect of a style. Glyphs are
/// turned, not fitted.
void inkcell_draw_on_circle(const inkcell_painter_t* painter,
                            const inkcell_font_t* font,
                            const char* text,
                            size_t size,
                            const inkcell_style_t* style,
                            const inkcell_text_circle_t* circle);

/// The pixels that it may touch.
void inkcell_circle_box(const inkcell_font_t* font,
                        const char* text,
                        size_t size,
                        const inkcell_style_t* style,
                        const inkcell_text_circle_t* circle,
                        inkcell_rect_t* out);

#ifdef __cplusplus
}
#endif
