// How text is set, and its lines.
#include "inkcell/c/layout.h"

#include "layouts.hpp"

using namespace inkcell;
using c::code;
using c::cpp;
using c::text_of;

INKCELL_SAME_VALUE(INKCELL_ALIGN_START, Align::start);
INKCELL_SAME_VALUE(INKCELL_ALIGN_LEFT, Align::left);
INKCELL_SAME_VALUE(INKCELL_ALIGN_CENTRE, Align::centre);
INKCELL_SAME_VALUE(INKCELL_ALIGN_RIGHT, Align::right);
INKCELL_SAME_VALUE(INKCELL_ALIGN_JUSTIFY, Align::justify);
INKCELL_SAME_VALUE(INKCELL_ELLIPSIS_NONE, Ellipsis::none);
INKCELL_SAME_VALUE(INKCELL_ELLIPSIS_END, Ellipsis::end);
INKCELL_SAME_VALUE(INKCELL_ELLIPSIS_MIDDLE, Ellipsis::middle);
INKCELL_SAME_VALUE(INKCELL_DIRECTION_FROM_TEXT, BaseDirection::from_text);
INKCELL_SAME_VALUE(INKCELL_LEFT_TO_RIGHT, BaseDirection::left_to_right);
INKCELL_SAME_VALUE(INKCELL_RIGHT_TO_LEFT, BaseDirection::right_to_left);

// LayoutOptions has private members besides, so that only GCC and Clang know
// the places of the others.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
INKCELL_SAME_PLACE(inkcell_layout_t, face, face);
static_assert(offsetof(inkcell_layout_t, fallback) ==
                  offsetof(LayoutOptions, fallback),
              "members differ");
INKCELL_SAME_PLACE(inkcell_layout_t, align, align);
INKCELL_SAME_PLACE(inkcell_layout_t, ellipsis, ellipsis);
INKCELL_SAME_PLACE(inkcell_layout_t, wraps, wraps);
INKCELL_SAME_PLACE(inkcell_layout_t, tabular_digits, tabular_digits);
INKCELL_SAME_PLACE(inkcell_layout_t, direction, direction);
INKCELL_SAME_PLACE(inkcell_layout_t, letter_spacing_q6, letter_spacing);
INKCELL_SAME_PLACE(inkcell_layout_t, line_height_q6, line_height);
static_assert(offsetof(inkcell_layout_t, tab_stops_q6) ==
                  offsetof(LayoutOptions, tab_stops),
              "members differ");
INKCELL_SAME_PLACE(inkcell_layout_t, tab_width_q6, tab_width);
#pragma GCC diagnostic pop
static_assert(sizeof(Span<const Face>) == sizeof(void*) + sizeof(size_t) &&
                  offsetof(Span<const Face>, size) == sizeof(void*),
              "members differ");
static_assert(sizeof(Q26_6) == sizeof(int32_t), "sizes differ");

INKCELL_SAME_PLACE(inkcell_line_t, begin, begin);
INKCELL_SAME_PLACE(inkcell_line_t, next, next);
INKCELL_SAME_PLACE(inkcell_line_t, paragraph, paragraph);
INKCELL_SAME_PLACE(inkcell_line_t, width, width);
INKCELL_SAME_PLACE(inkcell_line_t, length, length);
INKCELL_SAME_PLACE(inkcell_line_t, skip_at, skip_at);
INKCELL_SAME_PLACE(inkcell_line_t, skip_length, skip_length);
INKCELL_SAME_PLACE(inkcell_line_t, gaps, gaps);
INKCELL_SAME_PLACE(inkcell_line_t, base_level, base_level);
INKCELL_SAME_PLACE(inkcell_line_t, is_found, is_found);
INKCELL_SAME_PLACE(inkcell_line_t, is_last, is_last);
INKCELL_SAME_PLACE(inkcell_line_t, ends_paragraph, ends_paragraph);
INKCELL_SAME_PLACE(inkcell_line_t, has_hyphen, has_hyphen);
INKCELL_SAME_PLACE(inkcell_line_t, has_ellipsis, has_ellipsis);

void inkcell_layout_init(inkcell_layout_t* layout,
                         const inkcell_font_t* font,
                         const inkcell_style_t* style) {
  *cpp(layout) = LayoutOptions(*cpp(font), *cpp(style));
}

int32_t inkcell_layout_line_height(const inkcell_layout_t* layout) {
  return line_height(*cpp(layout)).raw;
}

int32_t inkcell_layout_baseline(const inkcell_layout_t* layout) {
  return baseline(*cpp(layout)).raw;
}

bool inkcell_next_line(const inkcell_layout_t* layout,
                       const char* text,
                       size_t size,
                       int32_t width_q6,
                       inkcell_line_t* line) {
  return next_line(*cpp(layout), text_of(text, size), Q26_6::from_raw(width_q6),
                   *cpp(line));
}

void inkcell_shorten_line(const inkcell_layout_t* layout,
                          const char* text,
                          size_t size,
                          int32_t width_q6,
                          inkcell_line_t* line) {
  shorten(*cpp(layout), text_of(text, size), Q26_6::from_raw(width_q6),
          *cpp(line));
}

inkcell_status_t inkcell_lay_out_line(const inkcell_layout_t* layout,
                                      const char* text,
                                      size_t size,
                                      const inkcell_line_t* line,
                                      int32_t width_q6,
                                      inkcell_positioned_glyph_t* out,
                                      size_t capacity,
                                      size_t* count) {
  Span<const PositionedGlyph> glyphs;
  const Status status =
      lay_out(*cpp(layout), text_of(text, size), *cpp(line),
              Q26_6::from_raw(width_q6), {cpp(out), capacity}, glyphs);
  *count = glyphs.size;
  return code(status);
}
