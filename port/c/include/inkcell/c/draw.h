// Text, runs and glyphs, as in inkcell/text.hpp and inkcell/prepared_glyph.hpp.
//
// (x_q6, y_q6) is the origin on the screen, the left end of the baseline, in
// px, y down. Text is UTF-8, any bytes; a size of INKCELL_TERMINATED: up to its
// zero byte. Drawing clips to the sink's window and cannot fail.
//
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#pragma once

#include "inkcell/c/font.h"
#include "inkcell/c/sink.h"
#include "inkcell/c/style.h"
#include "inkcell/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/// What becomes of characters that fonts lack, and how texts went:
/// inkcell/text_report.hpp. Make it with inkcell_text_report_init(), then
/// change what shall be different.
typedef struct INKCELL_SHARED inkcell_text_report_t {
  /// INKCELL_BOX, INKCELL_NOTHING, or a code point that is drawn instead.
  uint32_t instead;
  /// Null, or asked first: another code point for one that is missing.
  uint32_t (*substitute)(uint32_t code_point);
  uint32_t missing;         // characters; set it to 0 to count anew
  uint32_t first_missing;   // code point
  inkcell_status_t status;  // the first that was not INKCELL_OK
  void (*replace)(void);    // the library's own
} inkcell_text_report_t;
#define INKCELL_BOX UINT32_MAX
#define INKCELL_NOTHING (UINT32_MAX - 1)
void inkcell_text_report_init(inkcell_text_report_t* report);

/// The one door of text, as in inkcell/painter.hpp: a sink and, where they are
/// not null, RAM that is lent, a cache, and a report. Whatever measures or
/// draws text takes one; text is fitted for sinks of 1 and 2 bits, so that it
/// is measured as it is drawn.
///
///   const inkcell_painter_t painter = {.sink = &sink};
///
/// Null in its place is a painter that draws nothing: for boxes and measures
/// where no sink has 1 or 2 bits.
typedef struct inkcell_painter_t {
  const inkcell_sink_t* sink;
  /// All 0: drawing takes 1.4 KB of stack, 1.9 on sinks of 1 and 2 bits.
  inkcell_workspace_t ram;
  const struct inkcell_glyph_cache_t* cache;
  inkcell_text_report_t* report;
} inkcell_painter_t;


/// A glyph of a run. Font units, y up, from the run's origin on the baseline.
typedef struct INKCELL_SHARED inkcell_positioned_glyph_t {
  int32_t x;
  int16_t y;
  uint16_t glyph;
  uint16_t offset;  // of its first byte in the line
  uint8_t face;     // 0: the run's own; others: fallback[face - 1]
} inkcell_positioned_glyph_t;

/// A font and the style that draws it. Both must outlive it.
typedef struct INKCELL_SHARED inkcell_face_t {
  const inkcell_font_t* font;
  const inkcell_style_t* style;
} inkcell_face_t;

/// Width and ink of a line from its origin, y down, before the style turns it.
/// [px, Q6]
typedef struct INKCELL_SHARED inkcell_pixel_measure_t {
  int32_t advance_q6;
  int32_t left_q6;
  int32_t top_q6;
  int32_t right_q6;
  int32_t bottom_q6;
} inkcell_pixel_measure_t;

/// Lays out and draws one line.
void inkcell_draw_text(const inkcell_painter_t* painter,
                       const inkcell_font_t* font,
                       const char* text,
                       size_t size,
                       const inkcell_style_t* style,
                       int32_t x_q6,
                       int32_t y_q6);

/// Draws one glyph by its id.
void inkcell_draw_glyph(const inkcell_painter_t* painter,
                        const inkcell_font_t* font,
                        uint16_t glyph,
                        const inkcell_style_t* style,
                        int32_t x_q6,
                        int32_t y_q6);

/// Draws `count` glyphs that are laid out, along the style's direction. For a
/// screen in many strips: lay out once, draw for each.
void inkcell_draw_glyphs(const inkcell_painter_t* painter,
                         const inkcell_font_t* font,
                         const inkcell_positioned_glyph_t* glyphs,
                         size_t count,
                         const inkcell_style_t* style,
                         int32_t x_q6,
                         int32_t y_q6);

/// The same for runs of several fonts. Positions are in units of `face`;
/// `fallback`, of `fallback_count`, has the faces of other glyphs.
void inkcell_draw_faces(const inkcell_painter_t* painter,
                        const inkcell_face_t* face,
                        const inkcell_face_t* fallback,
                        size_t fallback_count,
                        const inkcell_positioned_glyph_t* glyphs,
                        size_t count,
                        int32_t x_q6,
                        int32_t y_q6);

/// The pixels that inkcell_draw_glyph() may touch, with filter, fitting and
/// effect, whatever the window is; empty if the glyph shows nothing.
void inkcell_glyph_box(const inkcell_painter_t* painter,
                       const inkcell_font_t* font,
                       uint16_t glyph,
                       const inkcell_style_t* style,
                       int32_t x_q6,
                       int32_t y_q6,
                       inkcell_rect_t* out);

/// The same of inkcell_draw_text().
void inkcell_box(const inkcell_painter_t* painter,
                 const inkcell_font_t* font,
                 const char* text,
                 size_t size,
                 const inkcell_style_t* style,
                 int32_t x_q6,
                 int32_t y_q6,
                 inkcell_rect_t* out);

/// The smallest rectangle that holds both; an empty one adds nothing.
void inkcell_bounding_box(const inkcell_rect_t* a,
                          const inkcell_rect_t* b,
                          inkcell_rect_t* out);

/// Positions of all glyphs of one line, into `out`, which has room for
/// `capacity`; as many as the text has bytes always suffice. `count` glyphs are
/// there.
///
/// BUFFER_SMALL: more than `capacity`; BAD_ARGUMENT: the text is longer than
/// 65,535 bytes. `count` is then 0.
inkcell_status_t inkcell_lay_out(const inkcell_painter_t* painter,
                                 const inkcell_font_t* font,
                                 const char* text,
                                 size_t size,
                                 const inkcell_style_t* style,
                                 inkcell_positioned_glyph_t* out,
                                 size_t capacity,
                                 size_t* count);

/// Measures one line, with the advances that inkcell_draw_text() takes.
void inkcell_measure(const inkcell_painter_t* painter,
                     const inkcell_font_t* font,
                     const char* text,
                     size_t size,
                     const inkcell_style_t* style,
                     inkcell_pixel_measure_t* out);

/// A length in font units at a style's size. [px, Q6, to the nearest]
int32_t inkcell_to_px(const inkcell_font_t* font,
                      const inkcell_style_t* style,
                      int32_t units);

/// A glyph of outlines that is decoded once and drawn into many strips. Opaque.
typedef struct INKCELL_SHARED inkcell_prepared_glyph_t {
  void* words[1];
} inkcell_prepared_glyph_t;

/// Places a glyph. `ram` is in use as long as `out` is: 8 bytes for each point,
/// the rest for rows; 2.5 KB hold every glyph of a Latin face.
///
/// BUFFER_SMALL: `ram` has less than 792 bytes, or 868 where pointers have 64
/// bits. NO_GLYPH: there is no glyph of this id. UNSUPPORTED: it is not one of
/// outlines.
inkcell_status_t inkcell_prepared_glyph_make(const inkcell_font_t* font,
                                             uint16_t glyph,
                                             const inkcell_style_t* style,
                                             int32_t x_q6,
                                             int32_t y_q6,
                                             const inkcell_workspace_t* ram,
                                             inkcell_prepared_glyph_t* out);

/// The pixels that it may touch; empty if it has no ink.
void inkcell_prepared_glyph_box(const inkcell_prepared_glyph_t* prepared,
                                inkcell_rect_t* out);

/// Draws what lies in the sink's window. Not by two tasks at once.
void inkcell_prepared_glyph_draw(const inkcell_prepared_glyph_t* prepared,
                                 const inkcell_sink_t* sink);

#ifdef __cplusplus
}
#endif
