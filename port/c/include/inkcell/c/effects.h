// Effects: glyphs drawn in another way than one sample a pixel.
//
// As in the C++ headers that are named. A style has one effect; its options,
// which the caller owns, must outlive the style. Functions that set an effect
// prepare it in `effect`, so that options are in RAM; call them again after a
// change. The linker drops the effects that a program does not name. Shadows
// and glows are filters: filter.h.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/filter.h"
#include "inkcell/c/sink.h"
#include "inkcell/c/style.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

// Strokes along edges: inkcell/stroke.hpp.

/// On which side of the edge a stroke lies.
enum {
  INKCELL_STROKE_INNER = 0,
  INKCELL_STROKE_CENTRED = 1,
  INKCELL_STROKE_OUTER = 2
};

/// A stroke, by the tables of its two edges, 532 bytes. Opaque.
typedef struct INKCELL_SHARED inkcell_stroke_t {
  const void* effect;
  inkcell_filter_table_t outer;
  inkcell_filter_table_t inner;
} inkcell_stroke_t;

/// A stroke `width_q10` px wide, 0 to 4 px, along the edge that `edge` draws.
/// `outer` becomes the filter of its outer edge, for
/// inkcell_filter_check_reach(); any filter will do for the style. `place` is
/// one of the above.
void inkcell_stroke_make(const inkcell_filter_t* edge,
                         int16_t width_q10,
                         uint8_t place,
                         inkcell_stroke_t* stroke,
                         inkcell_filter_t* outer);

/// Draws the stroke alone.
void inkcell_style_set_stroke(inkcell_style_t* style,
                              const inkcell_stroke_t* stroke);

/// Options of the effect that draws stroke and fill at once.
typedef struct INKCELL_SHARED inkcell_stroke_and_fill_t {
  const void* effect[2];
  /// Over the same strip as the sink that the stroke goes to, of another
  /// colour. Set it anew for each strip.
  const inkcell_sink_t* fill;
} inkcell_stroke_and_fill_t;

void inkcell_style_set_stroke_and_fill(inkcell_style_t* style,
                                       const inkcell_stroke_t* stroke,
                                       inkcell_stroke_and_fill_t* both);

// Sub-pixels: inkcell/lcd.hpp. Draw into a sink of inkcell_..._lcd_sink().

/// How stripes lie in a pixel: from left to right, or from top to bottom.
enum {
  INKCELL_SUB_PIXELS_RGB = 0,
  INKCELL_SUB_PIXELS_BGR = 1,
  INKCELL_SUB_PIXELS_RGB_VERTICAL = 2,
  INKCELL_SUB_PIXELS_BGR_VERTICAL = 3
};

typedef struct INKCELL_SHARED inkcell_lcd_t {
  uint8_t order;   // one of the above
  uint8_t colour;  // how much of the differences is kept: 0 none, 255 all
  const void* effect[2];
} inkcell_lcd_t;

void inkcell_style_set_lcd(inkcell_style_t* style, inkcell_lcd_t* options);

// 1 and 2 bits without broken strokes: inkcell/bilevel.hpp.

typedef struct INKCELL_SHARED inkcell_bilevel_t {
  uint8_t levels;         // of the display: 2 or 4
  int16_t threshold_q10;  // distance from which on a pixel is drawn, +-1/2 px
  const void* effect[2];
} inkcell_bilevel_t;

void inkcell_style_set_bilevel(inkcell_style_t* style,
                               inkcell_bilevel_t* options);

/// Contrast at small sizes: inkcell/edge_contrast.hpp. [1/256]
typedef struct INKCELL_SHARED inkcell_edge_contrast_t {
  uint8_t edge;  // 90 is a good value
  uint8_t thin;  // 96 is
  const void* effect[2];
} inkcell_edge_contrast_t;

void inkcell_style_set_edge_contrast(inkcell_style_t* style,
                                     inkcell_edge_contrast_t* options);

/// The mean of five pictures: inkcell/supersample.hpp.
typedef struct INKCELL_SHARED inkcell_supersample_t {
  int16_t radius_q10;  // 256..1536 [px]; 870 for text that stands, 768 if not
  const void* effect[2];
} inkcell_supersample_t;

void inkcell_style_set_supersample(inkcell_style_t* style,
                                   inkcell_supersample_t* options);

/// Up to 13 samples a pixel of a field: inkcell/field/circle_samples.hpp.
/// Opaque, 280 bytes. inkcell_font_check() refuses outlines.
typedef struct INKCELL_SHARED inkcell_circle_samples_t {
  uint32_t numbers[67];
  const void* words[3];
} inkcell_circle_samples_t;

/// `filter` is that of the style. `radius_q10` is clamped to 0.25..1.5 px.
/// `is_paper`: the paper's rule decides how many samples are taken.
void inkcell_circle_samples_make(const inkcell_filter_t* filter,
                                 int16_t radius_q10,
                                 bool is_paper,
                                 inkcell_circle_samples_t* out);

void inkcell_style_set_circle_samples(inkcell_style_t* style,
                                      const inkcell_circle_samples_t* options);

/// Coverage along a vector: inkcell/motion_blur.hpp. Opaque. Not to be used
/// after an error.
typedef struct INKCELL_SHARED inkcell_motion_blur_t {
  const void* word;
  uint32_t numbers[3];
} inkcell_motion_blur_t;

/// For a glyph that moves by so many px, y down, while it is seen.
/// BAD_ARGUMENT: more than 32 px along an axis.
inkcell_status_t inkcell_motion_blur_make(int32_t way_x_q6,
                                          int32_t way_y_q6,
                                          inkcell_motion_blur_t* out);

void inkcell_style_set_motion_blur(inkcell_style_t* style,
                                   const inkcell_motion_blur_t* options);

/// Cells smaller than a pixel, each once: inkcell/field/splat.hpp. Opaque. Not
/// to be used after an error. inkcell_font_check() refuses outlines.
typedef struct INKCELL_SHARED inkcell_splat_t {
  const void* words[4];
} inkcell_splat_t;

/// `sums`, at least 64, are in use while a glyph is drawn: one for each pixel
/// of the largest glyph in a strip is best. `radius_q10`: 768 to 1536, the
/// paper's is 1331. BUFFER_SMALL, BAD_ARGUMENT.
inkcell_status_t inkcell_splat_make(uint32_t* sums,
                                    size_t count,
                                    int16_t radius_q10,
                                    inkcell_splat_t* out);

void inkcell_style_set_splat(inkcell_style_t* style,
                             const inkcell_splat_t* options);

#ifdef __cplusplus
}
#endif
