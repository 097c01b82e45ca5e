// How text is set, and its lines, as in inkcell/layout/layout.hpp. text_box.h
// draws whole boxes; lines are for layouts of your own.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/draw.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  INKCELL_ALIGN_START = 0,  // left; right where text begins at the right
  INKCELL_ALIGN_LEFT = 1,
  INKCELL_ALIGN_CENTRE = 2,
  INKCELL_ALIGN_RIGHT = 3,
  INKCELL_ALIGN_JUSTIFY = 4  // but for the last line of a paragraph
};

/// What shows that text was left out.
enum {
  INKCELL_ELLIPSIS_NONE = 0,
  INKCELL_ELLIPSIS_END = 1,
  INKCELL_ELLIPSIS_MIDDLE = 2  // of text that does not wrap; else at the end
};

/// Where a paragraph begins.
enum {
  INKCELL_DIRECTION_FROM_TEXT = 0,
  INKCELL_LEFT_TO_RIGHT = 1,
  INKCELL_RIGHT_TO_LEFT = 2
};

/// Levels of mixed paragraphs (UAX #9). Opaque. One for each task that lays out
/// text.
typedef struct INKCELL_SHARED inkcell_bidi_t {
  const void* words[8];
} inkcell_bidi_t;

/// `cells`: one for each byte of the longest paragraph. What stands farther
/// from the beginning of its paragraph has the paragraph's own direction.
void inkcell_bidi_init(inkcell_bidi_t* bidi, uint16_t* cells, size_t count);

/// Call it when text was changed in place.
void inkcell_bidi_forget(inkcell_bidi_t* bidi);

/// How text is set. inkcell_layout_options_init() fills it in; then change what
/// shall be different. What is pointed to must outlive it.
typedef struct INKCELL_SHARED inkcell_layout_options_t {
  inkcell_face_t face;
  /// For characters that `face` lacks, in this order; at most 255.
  const inkcell_face_t* fallback;
  size_t fallback_count;
  uint8_t align;
  uint8_t ellipsis;
  bool wraps;           // where there is no more room; true at first
  bool tabular_digits;  // all digits are as wide as the widest
  uint8_t direction;
  int32_t letter_spacing_q6;  // [px]
  int32_t line_height_q6;     // [px] 0: that of the font, in whole px
  /// From the start of the line on, in rising order. [px, Q6] After the last
  /// one multiples of the tab width.
  const int32_t* tab_stops_q6;
  size_t tab_stop_count;
  int32_t tab_width_q6;  // [px] 0: eight spaces
  const void* words[2];  // of inkcell_layout_options_set_bidi()
} inkcell_layout_options_t;

/// One face, from the start, wrapped, all else 0.
void inkcell_layout_options_init(inkcell_layout_options_t* options,
                                 const inkcell_font_t* font,
                                 const inkcell_style_t* style);

/// Orders mixed lines. Without it all text is read from left to right.
void inkcell_layout_options_set_bidi(inkcell_layout_options_t* options,
                                     inkcell_bidi_t* bidi);

/// From a baseline to the next. [px, Q6]
int32_t inkcell_line_height(const inkcell_layout_options_t* options);

/// From the top of a line to its baseline. [px, Q6]
int32_t inkcell_baseline(const inkcell_layout_options_t* options);

/// A line of a text. It shows `length` bytes from `begin` on; spaces and line
/// ends behind that show nothing. All 0, it stands before the first line.
typedef struct INKCELL_SHARED inkcell_text_line_t {
  uint32_t begin;
  uint32_t next;       // where the next line begins
  uint32_t paragraph;  // where its paragraph begins
  int32_t width;       // [font units]
  uint16_t length;
  uint16_t skip_at;  // from `begin` on: an ellipsis stands there
  uint16_t skip_length;
  uint16_t gaps;       // where justified text is stretched
  uint8_t base_level;  // odd: it begins at the right
  bool is_found;       // by inkcell_next_line()
  bool is_last;        // of the text
  bool ends_paragraph;
  bool has_hyphen;  // at a soft hyphen
  bool has_ellipsis;
} inkcell_text_line_t;

/// Finds the line that follows `line` in `width_q6` px, and the first one if
/// that is all 0. False after the last; a text has a line more than line feeds.
///
///   inkcell_text_line_t line = {0};
///   while (inkcell_next_line(&options, NULL, text, size, width_q6, &line)) {}
bool inkcell_next_line(const inkcell_layout_options_t* options,
                       const inkcell_painter_t* painter,
                       const char* text,
                       size_t size,
                       int32_t width_q6,
                       inkcell_text_line_t* line);

/// Ends a line with an ellipsis, though its text goes on.
void inkcell_shorten(const inkcell_layout_options_t* options,
                     const inkcell_painter_t* painter,
                     const char* text,
                     size_t size,
                     int32_t width_q6,
                     inkcell_text_line_t* line);

/// Glyphs of a line from left to right, aligned in `width_q6` px, for
/// inkcell_draw_faces() with the faces of `options`. BUFFER_SMALL: more than
/// `capacity`; `count` is then 0. line->length + 4 always suffice.
inkcell_status_t inkcell_lay_out_line(const inkcell_layout_options_t* options,
                                      const inkcell_painter_t* painter,
                                      const char* text,
                                      size_t size,
                                      const inkcell_text_line_t* line,
                                      int32_t width_q6,
                                      inkcell_positioned_glyph_t* out,
                                      size_t capacity,
                                      size_t* count);

#ifdef __cplusplus
}
#endif
