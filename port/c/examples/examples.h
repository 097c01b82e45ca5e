// What the examples draw, each from a font and a text of yours. They return the
// first status that is not INKCELL_OK.
#pragma once

#include "inkcell/inkcell.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  LABEL_WIDTH = 96,
  LABEL_HEIGHT = 16,
  CLOCK_WIDTH = 120,
  CLOCK_HEIGHT = 40,
  CLOCK_ROWS = 8,
  PARAGRAPH_WIDTH = 80,
  PARAGRAPH_HEIGHT = 64,
  PLOT_WIDTH = 64,
  PLOT_HEIGHT = 24
};

/// A label in the middle of a display of 1 bit in pages. `pages`: a byte for
/// each column of 8 rows, 0 at first.
inkcell_status_t draw_label(const void* rom,
                            size_t rom_size,
                            const char* text,
                            uint8_t pages[LABEL_WIDTH * LABEL_HEIGHT / 8]);

/// A clock in strips of CLOCK_ROWS rows of RGB565, from a cache of glyphs.
/// `send` gets each strip. `stats`: what the cache did.
inkcell_status_t draw_clock(const void* rom,
                            size_t rom_size,
                            const char* text,
                            void (*send)(void* display,
                                         const inkcell_strip_t* strip),
                            void* display,
                            inkcell_glyph_cache_stats_t* stats);

/// A wrapped, centred paragraph in 8-bit grey, with an ellipsis if it is too
/// long. `pixels`: 0 at first.
inkcell_status_t draw_paragraph(
    const void* rom,
    size_t rom_size,
    const char* text,
    uint8_t pixels[PARAGRAPH_WIDTH * PARAGRAPH_HEIGHT]);

/// Text through a sink of its own, which takes the darkest of all coverages.
inkcell_status_t draw_plot(const void* rom,
                           size_t rom_size,
                           const char* text,
                           uint8_t pixels[PLOT_WIDTH * PLOT_HEIGHT]);

#ifdef __cplusplus
}
#endif
