// The device's library for a web page: one call draws a line of text into the
// memory of an emulated display. Without libc and without imports, as
// WebAssembly (build.sh); tests/web compares its pixels with the host's.
#pragma once

#include "inkcell/inkcell.h"

#ifdef __cplusplus
extern "C" {
#endif

/// How a sink treats coverage between 0 and 255.
enum { WEB_PLAIN = 0, WEB_DITHERED = 1, WEB_SUB_PIXELS = 2 };
/// Presets of filter.h, in their order there, then its soft edges.
enum {
  WEB_TEXT = 0,
  WEB_MOTION = 1,
  WEB_PAPER_DISPLAY = 2,
  WEB_PAPER_BODY = 3,
  WEB_AREA = 4,
  WEB_SHADOW = 5,
  WEB_GLOW = 6
};
enum { WEB_FIT_NONE = 0, WEB_FIT_HEIGHTS = 1, WEB_FIT_ACROSS = 2 };
enum {
  WEB_NO_EFFECT = 0,
  WEB_STROKE = 1,
  WEB_BILEVEL = 2,
  WEB_EDGE_CONTRAST = 3,
  WEB_SUPERSAMPLE = 4
};

/// What to draw, and where. In WebAssembly every member has four bytes: a page
/// writes an Int32Array.
typedef struct web_job_t {
  const uint8_t* rom;  // a multiple of 4
  size_t rom_size;
  const char* text;
  size_t text_size;
  uint8_t* pixels;
  size_t pixels_size;
  int32_t width;  // of the display [px]
  int32_t height;
  int32_t format;  // INKCELL_A8 and so on
  int32_t kind;    // WEB_PLAIN and so on
  int32_t colour;  // 0xRRGGBB, or a level; of 1 bit 0 or 1
  int32_t size_q6;
  int32_t x_q6;  // of the baseline's left end
  int32_t y_q6;
  int32_t cosine_q30;  // of the angle; 0 and 0 are upright
  int32_t sine_q30;
  int32_t filter;
  int32_t weight_q10;  // of presets and WEB_BILEVEL; reach of soft edges [px]
  int32_t fit;
  int32_t levels;  // of fitting: 0, 2 or 4
  int32_t effect;
  int32_t width_q10;  // of WEB_STROKE [px]
} web_job_t;

/// Reads the whole font.
inkcell_status_t web_verify(const web_job_t* job);

/// Draws the text. The strip is the whole display, without gaps between rows.
inkcell_status_t web_draw(const web_job_t* job);

/// The advance of the text. [px, Q6] 0 after an error.
int32_t web_advance(const web_job_t* job);

/// What bitmaps of all glyphs of the font take at this size: the boxes of their
/// ink, uncompressed, with `bits` a pixel. [bytes] Tables are not counted. 0
/// after an error.
uint32_t web_bitmap_bytes(const web_job_t* job, int32_t bits);

/// The number of glyphs; 0 after an error.
int32_t web_glyph_count(const web_job_t* job);

/// Whether the font has a character; 0 after an error.
int32_t web_has(const web_job_t* job, uint32_t code_point);

/// The sizes that the font was made for: the least in the lower 16 bits, the
/// largest above them. [px/em] 0 after an error.
uint32_t web_sizes(const web_job_t* job);

/// Draws the glyph between those of two code points, centred in a box whose
/// upper left corner is (x_q6, y_q6), with the filter motion.
inkcell_status_t web_morph(const web_job_t* job,
                           int32_t width,  // of the box [px]
                           int32_t height,
                           int32_t baseline,
                           uint32_t from,
                           uint32_t to,
                           int32_t progress_q16);

/// Generates the field of a character in RAM, and asks it at width x width
/// points. `pixels` then holds numbers of 32 bits: those of WEB_FIELD_HEAD,
/// which are the lower left corner of the square, its side [u], the bytes of
/// the field and its cells; and for each point, row by row from the top, the
/// distance [u, Q10], the lower left corner of its cell and its side [u], 0
/// where the cell is all outside or inside. NO_GLYPH: there is no ink.
inkcell_status_t web_field(const web_job_t* job, uint32_t code_point);
enum { WEB_FIELD_HEAD = 5 };

/// The distance in the field that web_field() has made last. [u, Q10]
int32_t web_distance(int32_t x_q16, int32_t y_q16);

/// Decodes the points and hints of a character. `pixels` then holds numbers of
/// 32 bits: how many points there are, and of each x, y [u, Q8] and its kind (0
/// off the curve, 1 smooth, 2 a corner, 3 a corner that begins a contour); how
/// many zones, and of each the height of flat edges and how far round ones pass
/// it; how many hints of heights, and of each its kind (0 bar, 1 serif, 2 edge,
/// 3 free end) and both heights; how many of stems, and of each both sides.
/// [u] NO_GLYPH: there is no outline.
inkcell_status_t web_points(const web_job_t* job, uint32_t code_point);

/// The sink that a job asks for, used by all that draw.
typedef union web_target_t {
  inkcell_a8_target_t a8;
  inkcell_grey8_target_t grey8;
  inkcell_grey4_target_t grey4;
  inkcell_grey2_target_t grey2;
  inkcell_mono_rows_target_t mono_rows;
  inkcell_mono_pages_target_t mono_pages;
  inkcell_rgb565_target_t rgb565;
  inkcell_rgb888_target_t rgb888;
  inkcell_xrgb8888_target_t xrgb8888;
} web_target_t;
inkcell_status_t web_sink(const web_job_t* job,
                          web_target_t* target,
                          inkcell_sink_t* out);

#ifdef __cplusplus
}
#endif
