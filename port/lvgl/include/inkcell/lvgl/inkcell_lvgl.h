// Inkcell fonts in LVGL 9: a lv_font_t of any size from one font in ROM.
//
//   static inkcell_lv_font_t clock_font;
//   inkcell_lv_font_init(&clock_font, rom, rom_bytes, 28 * 64);
//   lv_obj_set_style_text_font(label, &clock_font.lv, 0);
//
// The caller owns all memory. Fonts, fits, weights, caches and the mapped ROM
// must stay in place until LVGL no longer draws with the font. The adapter
// allocates only the draw unit of inkcell_lv_font_set_direct(), once, from
// LVGL's heap.
//
// A font is a lv_font_t, so LVGL's own settings work: lv_font_set_kerning(),
// `font.lv.fallback`, `font.lv.line_height`, `font.lv.underline_position`. The
// linker drops functions that the program does not call.
//
// A function that returns LV_RESULT_INVALID logs why, by LV_LOG_ERROR.
#ifndef INKCELL_LVGL_H
#define INKCELL_LVGL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __has_include
#  if !__has_include("lvgl.h")
#    error \
        "Inkcell needs LVGL 9: its target lvgl, or its folder to include from"
#  endif
#endif
#include "lvgl.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The size of C++ objects in pointers, on 64-bit and 32-bit machines. */
#define INKCELL_LV_POINTERS(of_64, of_32) \
  (sizeof(void*) == 8 ? (of_64) : (of_32))

/** A font at one size. */
typedef struct {
  lv_font_t lv; /**< for LVGL's functions */
  void* state[INKCELL_LV_POINTERS(44, 64)];
} inkcell_lv_font_t;

/** Grid fitting at one size, for one font. */
typedef struct {
  void* state[INKCELL_LV_POINTERS(24, 44)];
} inkcell_lv_fit_t;

/** Strokes that are bolder or lighter. */
typedef struct {
  void* state[INKCELL_LV_POINTERS(34, 67)];
} inkcell_lv_weight_t;

/** The tables of a TrueType file; one serves fonts of any size. */
typedef struct {
  void* state[INKCELL_LV_POINTERS(45, 56)];
} inkcell_lv_truetype_t;

/** A cache of drawn glyphs; one may serve several fonts. */
typedef struct {
  void* state[3];
} inkcell_lv_cache_t;

/** The order of a display's sub-pixels. */
typedef enum {
  INKCELL_LV_SUB_PIXELS_RGB,
  INKCELL_LV_SUB_PIXELS_BGR,
  INKCELL_LV_SUB_PIXELS_RGB_VERTICAL,
  INKCELL_LV_SUB_PIXELS_BGR_VERTICAL
} inkcell_lv_sub_pixels_t;

/** Makes a font of `size_q6` 1/64 px to the em, 4 to 1024 px: 14.5 px are 928.
 *
 * `rom` is a font made by inkcell_add_font() or inkcell-fontgen, aligned to 4,
 * in flash or RAM, `rom_bytes` long or longer. Any bytes are safe; wrong ones
 * draw wrong pictures.
 *
 * Line height and base line are those of the font file, rounded up to pixels.
 * The font format has no underline: thickness is em / 20, position em / 10
 * below the base line, at least 1 px each. Advances are rounded to pixels after
 * kerning, as LVGL needs. LVGL looks up code points that the font lacks in
 * `font->lv.fallback`.
 *
 * LVGL draws the glyphs as A8 bitmaps: its draw buffer holds a whole glyph.
 *
 * LV_RESULT_INVALID: the ROM is no font that this build reads, or the size is
 * out of range; `font` is then untouched. */
lv_result_t inkcell_lv_font_init(inkcell_lv_font_t* font,
                                 const void* rom,
                                 size_t rom_bytes,
                                 int32_t size_q6);

/** The same of a font of strikes alone, pictures of glyphs at one size, which
 * `size_q6` is, or a whole multiple of it; else LV_RESULT_INVALID. Such a font
 * is not fitted, and has no weight and no sub-pixels. */
lv_result_t inkcell_lv_font_init_strike(inkcell_lv_font_t* font,
                                        const void* rom,
                                        size_t rom_bytes,
                                        int32_t size_q6);

/** The same of outlines with strikes of 4 bits beside them, in the style that
 * those serve: fitted to the grid of pixels, heights alone unless `across`.
 * Glyphs without a picture at that size are drawn from their outlines. */
lv_result_t inkcell_lv_font_init_outline_strike(inkcell_lv_font_t* font,
                                                const void* rom,
                                                size_t rom_bytes,
                                                int32_t size_q6,
                                                bool across);

/** Opens a TrueType file that lies in flash or RAM, at any address, and must
 * stay there: no generator, and no heap. inkcell_lv_font_init_truetype() makes
 * fonts of it. LV_RESULT_INVALID: it is none, or has outlines of CFF; `file` is
 * then untouched. */
lv_result_t inkcell_lv_truetype_open(inkcell_lv_truetype_t* file,
                                     const void* bytes,
                                     size_t count);

/** As inkcell_lv_font_init() of a TrueType file, which must stay open. Glyphs
 * are drawn in exact area: such a font has no weight. */
lv_result_t inkcell_lv_font_init_truetype(inkcell_lv_font_t* font,
                                          const inkcell_lv_truetype_t* file,
                                          int32_t size_q6);

/** Draws glyphs straight into LVGL's layer, a strip or a screen, in LVGL's
 * colour formats and opacities, without a buffer for a glyph.
 *
 * The first call registers a draw unit with LVGL, which then draws the labels
 * and letters with such a font in their chain of fallbacks; call lv_init()
 * before, which LV_ASSERT_MSG checks, and this anew after lv_deinit(). The unit
 * draws on the task that calls LVGL. It needs LV_USE_DRAW_SW.
 *
 * Letters that lv_draw_letter() and lv_arclabel turn, scale or skew are drawn
 * from their outlines, about the pivot on their base line; widgets that are
 * transformed are turned by LVGL, as pictures. */
void inkcell_lv_font_set_direct(inkcell_lv_font_t* font);

/** Makes the font direct, and has it draw icons and emoji of a font made with
 * inkcell-fontgen --colour in their colours, into any layer. Parts of a glyph
 * that are drawn with an opacity show what is below them. Such a font has no
 * sub-pixels. */
void inkcell_lv_font_set_colours(inkcell_lv_font_t* font);

/** Has a direct font draw the strokes that styles ask for
 * (text_outline_stroke_width, 0 to 3 px, _color and _opa), below letters and
 * around them. Without it LV_LOG_WARN says once that there is none. Fonts of
 * TrueType files and of strikes have none. LVGL redraws a label's own area:
 * strokes beyond it want padding. */
void inkcell_lv_font_set_outline_stroke(inkcell_lv_font_t* font);

/** Draws with a coverage for each sub-pixel, if the font is direct, the layer
 * is RGB565, RGB888 or XRGB8888, and the opacity is full; else in grey. A
 * weight does not count then, which LV_LOG_WARN says. */
void inkcell_lv_font_set_sub_pixels(inkcell_lv_font_t* font,
                                    inkcell_lv_sub_pixels_t order);

/** Fits heights to the grid of pixels: base lines, x-height and horizontal
 * strokes are crisp. Fades from 24 to 40 px. LV_RESULT_INVALID: the font's
 * hints are corrupt; nothing is changed then. */
lv_result_t inkcell_lv_font_fit_heights(inkcell_lv_font_t* font,
                                        inkcell_lv_fit_t* fit);

/** The same, and widths: stems and advances are whole pixels. Best to 11 px;
 * lines get 3 to 14 % longer. */
lv_result_t inkcell_lv_font_fit_grid(inkcell_lv_font_t* font,
                                     inkcell_lv_fit_t* fit);

/** Moves edges outwards by `weight_q6` 1/64 px, inwards if it is negative:
 * strokes gain twice that. Clamped to about +-3.5 px. Advances stay.
 * LV_RESULT_INVALID: the font, of a TrueType file or of strikes, has no weight;
 * nothing is changed then. */
lv_result_t inkcell_lv_font_set_weight(inkcell_lv_font_t* font,
                                       inkcell_lv_weight_t* weight,
                                       int32_t weight_q6);

/** Gives the font a workspace for outlines, aligned to 4, instead of 1.1 KB of
 * stack; 2560 bytes also speed up large glyphs. Fonts of a task may
 * share it; with LV_DRAW_SW_DRAW_UNIT_CNT over 1 only if they are direct. */
void inkcell_lv_font_set_workspace(inkcell_lv_font_t* font,
                                   void* ram,
                                   size_t bytes);

/** Makes a cache in `ram`, aligned to the size of a pointer, with 4 bits a
 * pixel (coverage is off by at most 8/255) for up to `fonts` fonts, 1 to 16.
 * For n different letters of s px they want about 600 + n (16 + 4.5 s) bytes.
 *
 * LV_RESULT_INVALID: `fonts` is out of range, `ram` is misaligned, or has less
 * than 512 bytes for each font. `cache` is then untouched. */
lv_result_t inkcell_lv_cache_init(inkcell_lv_cache_t* cache,
                                  void* ram,
                                  size_t bytes,
                                  uint32_t fonts);

/** Makes the font direct, and keeps drawn glyphs in a cache: the fastest way
 * for text that is drawn more than once. Set it after fit, weight and
 * sub-pixels: a change of these needs a new cache. Turned letters, strokes and
 * widgets that are transformed are drawn without it. */
void inkcell_lv_font_set_cache(inkcell_lv_font_t* font,
                               inkcell_lv_cache_t* cache);

/** What a cache has done since it was made, and what it holds. */
typedef struct {
  uint32_t hits;
  uint32_t misses;    /**< drawn, and kept */
  uint32_t bypasses;  /**< drawn, too large to be kept */
  uint32_t evictions; /**< glyphs that made room for others */
  uint32_t glyphs;    /**< that it holds */
  uint32_t bytes;     /**< that are in use */
  uint32_t capacity;  /**< bytes that it was lent */
} inkcell_lv_cache_stats_t;

/** Fills in `out`. A cache with more evictions than hits costs time;
 * LV_LOG_WARN says so once for a font. */
void inkcell_lv_cache_stats(const inkcell_lv_cache_t* cache,
                            inkcell_lv_cache_stats_t* out);

#ifdef __cplusplus
}
#endif

#endif /* INKCELL_LVGL_H */
