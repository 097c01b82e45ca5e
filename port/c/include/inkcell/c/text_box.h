// Text in a rectangle, and a line that scrolls, as in text_box.hpp and
// label.hpp of inkcell/layout/. Upright text only: the style must not be
// turned.
//
// Functions of boxes find the lines of the text anew. Where a screen is drawn
// in many strips, find them once with inkcell_text_box_lay_out(), and hand them
// to the others as `lines` and `line_count`: lines of the same text, options
// and width. Else `lines` is null.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/layout.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  INKCELL_VERTICAL_TOP = 0,
  INKCELL_VERTICAL_MIDDLE = 1,   // of the lines
  INKCELL_VERTICAL_OPTICAL = 2,  // of capitals
  INKCELL_VERTICAL_BOTTOM = 3
};

/// inkcell_text_box_init() fills it in; then change what shall be different.
typedef struct INKCELL_SHARED inkcell_text_box_t {
  inkcell_layout_options_t options;
  /// Where lines stand on the screen, within +-32767 px. Ink may overhang it.
  inkcell_rect_t rect;
  /// What is outside of it is cut off; by default nothing is.
  inkcell_rect_t clip;
  uint8_t vertical;
} inkcell_text_box_t;

/// A place between characters.
typedef struct INKCELL_SHARED inkcell_text_place_t {
  size_t offset;     // in the text [bytes]
  bool is_line_end;  // of the two carets where a line wraps: the first
} inkcell_text_place_t;

/// What a text takes of a box.
typedef struct INKCELL_SHARED inkcell_text_size_t {
  int32_t width_q6;   // of the longest line [px]
  int32_t height_q6;  // of all lines [px]
  size_t lines;
} inkcell_text_size_t;

/// A box at the top and the start of `rect`.
void inkcell_text_box_init(inkcell_text_box_t* box,
                           const inkcell_font_t* font,
                           const inkcell_style_t* style,
                           const inkcell_rect_t* rect);

/// Finds the lines that are drawn, with an ellipsis no more than there is room
/// for. BUFFER_SMALL: there are more than `capacity`; `count` is then 0.
inkcell_status_t inkcell_text_box_lay_out(const inkcell_text_box_t* box,
                                          const inkcell_painter_t* painter,
                                          const char* text,
                                          size_t size,
                                          inkcell_text_line_t* out,
                                          size_t capacity,
                                          size_t* count);

/// Draws the lines that meet the sink's window.
void inkcell_text_box_draw(const inkcell_text_box_t* box,
                           const inkcell_painter_t* painter,
                           const char* text,
                           size_t size,
                           const inkcell_text_line_t* lines,
                           size_t line_count);

/// The pixels that inkcell_text_box_draw() may touch; empty if nothing shows.
void inkcell_text_box_box(const inkcell_text_box_t* box,
                          const inkcell_painter_t* painter,
                          const char* text,
                          size_t size,
                          const inkcell_text_line_t* lines,
                          size_t line_count,
                          inkcell_rect_t* out);

/// The advances: a rectangle of that size cuts nothing.
void inkcell_text_box_measure(const inkcell_text_box_t* box,
                              const inkcell_painter_t* painter,
                              const char* text,
                              size_t size,
                              const inkcell_text_line_t* lines,
                              size_t line_count,
                              inkcell_text_size_t* out);

/// The caret nearest to the middle of a pixel: in the line at its height, or
/// the first or last one.
void inkcell_text_box_hit(const inkcell_text_box_t* box,
                          const inkcell_painter_t* painter,
                          const char* text,
                          size_t size,
                          int32_t x,
                          int32_t y,
                          const inkcell_text_line_t* lines,
                          size_t line_count,
                          inkcell_text_place_t* out);

/// The caret at a place: a column as high as the line.
void inkcell_text_box_caret(const inkcell_text_box_t* box,
                            const inkcell_painter_t* painter,
                            const char* text,
                            size_t size,
                            const inkcell_text_place_t* place,
                            const inkcell_text_line_t* lines,
                            size_t line_count,
                            inkcell_rect_t* out);

/// One line of text in a window, drawn at any scroll. Opaque.
typedef struct INKCELL_SHARED inkcell_scrolling_label_t {
  const void* words[7];
  uint32_t numbers[6];
} inkcell_scrolling_label_t;

/// Lays out the first line of a text, in the middle of the height of `window`,
/// into `room`, which must outlive the label, as must the faces of `options`,
/// but not the text. A glyph for each byte always suffices.
///
/// BUFFER_SMALL: more than `capacity` glyphs. BAD_ARGUMENT: the text is longer
/// than 65,535 bytes.
inkcell_status_t inkcell_scrolling_label_make(
    const inkcell_layout_options_t* options,
    const inkcell_painter_t* painter,
    const char* text,
    size_t size,
    const inkcell_rect_t* window,
    inkcell_positioned_glyph_t* room,
    size_t capacity,
    inkcell_scrolling_label_t* out);

/// The width of the line. [px, Q6]
int32_t inkcell_scrolling_label_width(const inkcell_scrolling_label_t* label);

/// Whether the line is wider than the window.
bool inkcell_scrolling_label_needs_scrolling(
    const inkcell_scrolling_label_t* label);

/// Draws the line moved to the left by `scroll_q6` px.
void inkcell_scrolling_label_draw(const inkcell_scrolling_label_t* label,
                                  const inkcell_painter_t* painter,
                                  int32_t scroll_q6);

/// The same for a line that follows itself without end, `gap_q6` px behind.
void inkcell_scrolling_label_draw_endless(
    const inkcell_scrolling_label_t* label,
    const inkcell_painter_t* painter,
    int32_t scroll_q6,
    int32_t gap_q6);

#ifdef __cplusplus
}
#endif
