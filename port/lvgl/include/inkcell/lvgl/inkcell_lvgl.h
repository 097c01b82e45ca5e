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
#ifndef INKCELL_LVGL_H
#define INKCELL_LVGL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

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

/** Draws glyphs straight into LVGL's layer, a strip or a screen, in LVGL's
 * colour formats and opacities, without a buffer for a glyph: for large sizes.
 *
 * The first call registers a draw unit with LVGL, which then draws the labels
 * and letters with such a font in their chain of fallbacks; call lv_init()
 * before, and this anew after lv_deinit(). The unit draws on the task that
 * calls LVGL. It needs LV_USE_DRAW_SW. Rotated letters (lv_draw_letter,
 * lv_arclabel) of such a font are not drawn; transformed labels are. */
void inkcell_lv_font_set_direct(inkcell_lv_font_t* font);

/** Draws with a coverage for each sub-pixel, if the font is direct, the layer
 * is RGB565, RGB888 or XRGB8888, and the opacity is full; else in grey. */
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
 * strokes gain twice that. Clamped to about +-3.5 px. Advances stay. */
void inkcell_lv_font_set_weight(inkcell_lv_font_t* font,
                                inkcell_lv_weight_t* weight,
                                int32_t weight_q6);

/** Gives the font a workspace for outlines, aligned to 4, instead of 1.1 KB of
 * stack; 2560 bytes also speed up large glyphs. Fonts of a task may
 * share it. */
void inkcell_lv_font_set_workspace(inkcell_lv_font_t* font,
                                   void* ram,
                                   size_t bytes);

/** Makes a cache in `ram`, aligned to the size of a pointer, with 4 bits a
 * pixel (coverage is off by at most 8/255) for up to `fonts` fonts, 1 to 16.
 *
 * LV_RESULT_INVALID: `fonts` is out of range, `ram` is misaligned, or has less
 * than 512 bytes for each font. `cache` is then untouched. */
lv_result_t inkcell_lv_cache_init(inkcell_lv_cache_t* cache,
                                  void* ram,
                                  size_t bytes,
                                  uint32_t fonts);

/** Keeps drawn glyphs in a cache. Set it after fit, weight and sub-pixels: a
 * change of these needs a new cache. With LV_DRAW_SW_DRAW_UNIT_CNT over 1 only
 * fonts that are direct may have a cache or a workspace. */
void inkcell_lv_font_set_cache(inkcell_lv_font_t* font,
                               inkcell_lv_cache_t* cache);

#ifdef __cplusplus
}
#endif

#endif /* INKCELL_LVGL_H */
