// Styles and grid fitting, as in inkcell/style.hpp and inkcell/fit.hpp.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/filter.h"
#include "inkcell/c/font.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Size, direction, filter, fitting and effect. Opaque. Empty, it draws
/// nothing.
typedef struct INKCELL_SHARED inkcell_style_t {
  uint32_t numbers[14];
  const void* words[6];
} inkcell_style_t;

/// Where a glyph's axes lead on the screen. [px to the em, Q16]
///
///     right = x_right x + y_right y     (x, y) is a place in the glyph, in em
///     up    = x_up    x + y_up    y
typedef struct INKCELL_SHARED inkcell_matrix_t {
  int32_t x_right_q16;
  int32_t x_up_q16;
  int32_t y_right_q16;
  int32_t y_up_q16;
} inkcell_matrix_t;

/// An upright style of `size_q6` px to the em, 4 to 1024: else BAD_ARGUMENT.
inkcell_status_t inkcell_style_make(int32_t size_q6,
                                    const inkcell_filter_t* filter,
                                    inkcell_style_t* out);

/// An upright style of the size at which capitals, or digits, are `height_q6`
/// px high; the size is clamped to 4 to 1024 px/em. A font without them has its
/// cap height, else its em, of that height.
void inkcell_style_for_cap_height(const inkcell_font_t* font,
                                  int32_t height_q6,
                                  const inkcell_filter_t* filter,
                                  inkcell_style_t* out);
void inkcell_style_for_digit_height(const inkcell_font_t* font,
                                    int32_t height_q6,
                                    const inkcell_filter_t* filter,
                                    inkcell_style_t* out);

/// A style that is turned counter-clockwise by the angle of this cosine and
/// sine. [Q30] BAD_ARGUMENT: also if they are not those of an angle, within
/// 1/1000.
inkcell_status_t inkcell_style_make_turned(int32_t size_q6,
                                           const inkcell_filter_t* filter,
                                           int32_t cosine_q30,
                                           int32_t sine_q30,
                                           inkcell_style_t* out);

/// A style that maps glyphs by a matrix. BAD_ARGUMENT: its least or its
/// greatest stretch is outside 4 to 1024 px.
inkcell_status_t inkcell_style_make_mapped(const inkcell_matrix_t* matrix,
                                           const inkcell_filter_t* filter,
                                           inkcell_style_t* out);

/// Px to the em; of a matrix the greatest stretch. [Q6]
int32_t inkcell_style_size(const inkcell_style_t* style);

/// Takes the effect of effects.h off: one sample a pixel, the default.
void inkcell_style_clear_effect(inkcell_style_t* style);

/// UNSUPPORTED: the style's effect does not draw glyphs of this font, and
/// nothing shows.
inkcell_status_t inkcell_font_check(const inkcell_font_t* font,
                                    const inkcell_style_t* style);

/// A font's hints at one size. Opaque. Empty, it moves nothing.
typedef struct INKCELL_SHARED inkcell_fit_t {
  const void* words[1];
  uint32_t numbers[17];
} inkcell_fit_t;

/// For styles of the same size and glyphs of this font: others are drawn with
/// the wrong hints. CORRUPT: the font's hints; BAD_ARGUMENT: `levels` or
/// `strength_q8`.
///
/// `across`: stems and advances are whole pixels, too. `levels`, of the
/// display: 0, many; 2 or 4. `strength_q8`: how much of the way to the grid
/// glyphs go, 0 none, 256 all of it.
inkcell_status_t inkcell_fit_make(const inkcell_font_t* font,
                                  const inkcell_style_t* style,
                                  bool across,
                                  uint8_t levels,
                                  uint16_t strength_q8,
                                  inkcell_fit_t* out);

/// Whether advances are whole pixels: lay out and measure with the style then.
bool inkcell_fit_has_advances(const inkcell_fit_t* fit);

/// For inkcell_bilevel_t: the weight that whole stems have. [px, Q10]
int16_t inkcell_fit_bilevel_weight(const inkcell_fit_t* fit);

/// Fits glyphs of outlines of an upright style. `fit` must outlive the style.
void inkcell_style_set_fit(inkcell_style_t* style, const inkcell_fit_t* fit);

/// The same for heights alone, in two thirds of the code.
void inkcell_style_set_fit_heights(inkcell_style_t* style,
                                   const inkcell_fit_t* fit);

/// Fits text for displays of 2 levels, or of 4, as painters of sinks of 1 and 2
/// bits do by themselves (inkcell/few_levels.hpp), below 40 px to the em. Needs
/// no inkcell_fit_t.
void inkcell_style_fit_levels(inkcell_style_t* style, uint8_t levels);

/// Glyphs stay as designed, also on sinks of 1 and 2 bits.
void inkcell_style_clear_fit(inkcell_style_t* style);

#ifdef __cplusplus
}
#endif
