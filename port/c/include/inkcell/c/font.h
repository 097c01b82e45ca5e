// Fonts in ROM, as in inkcell/font.hpp: opened in constant time, safe with any
// bytes.
//
// `inkcell-fontgen --format c` writes a font as a C source, and with --header
// what declares its array and its size:
//
//   extern const uint8_t dejavu_sans[];
//   extern const uint32_t dejavu_sans_size;
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A view of a font in read-only memory, which must outlive it. Opaque. Empty,
/// it has no glyphs.
typedef struct INKCELL_SHARED inkcell_font_t {
  const void* words[15];
  uint32_t numbers[4];
} inkcell_font_t;

/// Measures of one glyph in font units, y up, origin on the baseline. The box
/// is that of the ink; it is empty for a space. x_min is the left bearing.
typedef struct INKCELL_SHARED inkcell_glyph_metrics_t {
  int32_t advance;
  int16_t x_min;
  int16_t y_min;
  int16_t x_max;
  int16_t y_max;
} inkcell_glyph_metrics_t;

/// Measures of the font in font units, y up: the descender is negative. A line
/// is ascender - descender + line_gap high. The box, x_min to y_max, is that of
/// all ink.
typedef struct INKCELL_SHARED inkcell_font_metrics_t {
  uint16_t units_per_em;
  int16_t ascender;
  int16_t descender;
  int16_t line_gap;
  int16_t x_height;
  int16_t cap_height;
  int16_t x_min;
  int16_t y_min;
  int16_t x_max;
  int16_t y_max;
} inkcell_font_metrics_t;

/// What the font was generated for.
typedef struct INKCELL_SHARED inkcell_font_range_t {
  uint16_t min_px;  // [px/em]
  uint16_t max_px;
  uint16_t band_u;     // distances are good up to here [1/1024 em]
  uint8_t tolerance;   // worst coverage error that was allowed [1/255]
  uint16_t max_cells;  // of any glyph
  uint16_t max_nodes;
  uint8_t max_depth;  // steps from a tile to its smallest cell
} inkcell_font_range_t;

/// Opens the font that begins at `rom`, a multiple of 4. `size` [bytes] may be
/// more than the font's.
///
/// BAD_MAGIC, BAD_VERSION, MISALIGNED, CORRUPT (header, directory or table
/// sizes), UNSUPPORTED (a section that this version cannot read, or another
/// coding).
inkcell_status_t inkcell_font_open(const void* rom,
                                   size_t size,
                                   inkcell_font_t* out);

/// The same of a font of fields.
inkcell_status_t inkcell_font_open_field(const void* rom,
                                         size_t size,
                                         inkcell_font_t* out);

/// Reads the whole font: checksum, tables and references. Never needed for
/// safety. Time is proportional to its size. CORRUPT: something does not fit.
inkcell_status_t inkcell_font_verify(const inkcell_font_t* font);

uint16_t inkcell_font_glyph_count(const inkcell_font_t* font);

/// Whether glyphs are outlines, and not cells.
bool inkcell_font_has_outlines(const inkcell_font_t* font);
void inkcell_font_metrics(const inkcell_font_t* font,
                          inkcell_font_metrics_t* out);
void inkcell_font_range(const inkcell_font_t* font, inkcell_font_range_t* out);

/// The glyph of a code point. NO_GLYPH: the font has none; `out` is then 0,
/// which is .notdef.
inkcell_status_t inkcell_font_glyph_of(const inkcell_font_t* font,
                                       uint32_t code_point,
                                       uint16_t* out);

/// NO_GLYPH: there is no glyph of this id; `out` is then all 0.
inkcell_status_t inkcell_font_glyph_metrics(const inkcell_font_t* font,
                                            uint16_t glyph,
                                            inkcell_glyph_metrics_t* out);

/// The advance alone, which is faster; 0 if there is no such glyph. [font
/// units]
int32_t inkcell_font_advance(const inkcell_font_t* font, uint16_t glyph);

/// What to add to the advance of `left` when `right` follows; 0 if the font
/// says nothing about the pair. [font units]
int32_t inkcell_font_kerning(const inkcell_font_t* font,
                             uint16_t left,
                             uint16_t right);

/// The font's name and its `size` [bytes], UTF-8, not terminated; size 0 if it
/// has none. In the font's memory.
const char* inkcell_font_name(const inkcell_font_t* font, size_t* size);

#ifdef __cplusplus
}
#endif
