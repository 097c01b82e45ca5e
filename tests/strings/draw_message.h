// Text that comes at run time, shaped by a program of C.
#pragma once

#include "inkcell/c/draw.h"

#ifdef __cplusplus
extern "C" {
#endif

/// As a line at (20, 60), and in a box from (20, 80) on, 200 px wide.
void draw_message(const inkcell_font_t* font,
                  const inkcell_style_t* style,
                  const inkcell_sink_t* sink,
                  const char* text);

#ifdef __cplusplus
}
#endif
