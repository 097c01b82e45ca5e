// Text, runs and glyphs, as in inkcell/text.hpp and inkcell/prepared_glyph.hpp.
//
// (x_q6, y_q6) is the origin on the screen, the left end of the baseline, in
// px, y down. Text is UTF-8, any bytes; a size of INKCELL_TERMINATED: up to its
// zero byte. `ram` may be null: drawing then takes 1.6 KB of stack. Drawing
// clips to the sink's window and cannot fail.
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

/// Width and ink of a line in font units, y up, from its origin. The ink box is
/// empty if x_max <= x_min.
typedef struct INKCELL_SHARED inkcell_text_measure_t {
  int32_t advance;
  int32_t x_min;
  int32_t y_min;
  int32_t x_max;
  int32_t y_max;
} inkcell_text_measure_t;

/// Lays out and draws one line with the advances of the style.
void inkcell_draw_text(const inkcell_font_t* font,
                       const char* text,
                       size_t size,
                       const inkcell_style_t* style,
                       int32_t x_q6,
                       int32_t y_q6,
                       const inkcell_sink_t* sink,
                       const inkcell_workspace_t* ram);

/// Draws one glyph by its id.
void inkcell_draw_glyph(const inkcell_font_t* font,
                        uint16_t glyph,
                        const inkcell_style_t* style,
                        int32_t x_q6,
                        int32_t y_q6,
                        const inkcell_sink_t* sink,
                        const inkcell_workspace_t* ram);

/// Draws `count` glyphs that are laid out, along the style's direction. For a
/// screen in many strips: lay out once, draw for each.
void inkcell_draw_glyphs(const inkcell_font_t* font,
                         const inkcell_positioned_glyph_t* glyphs,
                         size_t count,
                         const inkcell_style_t* style,
                         int32_t x_q6,
                         int32_t y_q6,
                         const inkcell_sink_t* sink,
                         const inkcell_workspace_t* ram);

/// The same for runs of several fonts. Positions are in units of `face`;
/// `fallback`, of `fallback_count`, has the faces of other glyphs.
void inkcell_draw_faces(const inkcell_face_t* face,
                        const inkcell_face_t* fallback,
                        size_t fallback_count,
                        const inkcell_positioned_glyph_t* glyphs,
                        size_t count,
                        int32_t x_q6,
                        int32_t y_q6,
                        const inkcell_sink_t* sink,
                        const inkcell_workspace_t* ram);

/// The pixels that inkcell_draw_glyph() may touch, with filter, fitting and
/// effect, whatever the window is; empty if the glyph shows nothing.
void inkcell_glyph_box(const inkcell_font_t* font,
                       uint16_t glyph,
                       const inkcell_style_t* style,
                       int32_t x_q6,
                       int32_t y_q6,
                       inkcell_rect_t* out);

/// The same of inkcell_draw_text().
void inkcell_box(const inkcell_font_t* font,
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
/// there. With `style`, which may be null: with its advances.
///
/// BUFFER_SMALL: more than `capacity`; BAD_ARGUMENT: the text is longer than
/// 65,535 bytes. `count` is then 0.
inkcell_status_t inkcell_lay_out(const inkcell_font_t* font,
                                 const char* text,
                                 size_t size,
                                 const inkcell_style_t* style,
                                 inkcell_positioned_glyph_t* out,
                                 size_t capacity,
                                 size_t* count);

/// Measures one line, of a style or, if that is null, as designed.
void inkcell_measure(const inkcell_font_t* font,
                     const char* text,
                     size_t size,
                     const inkcell_style_t* style,
                     inkcell_text_measure_t* out);

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
/// BUFFER_SMALL: `ram` has less than 824 bytes, or 900 where pointers have 64
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
