// Text in a rectangle.
#include "inkcell/c/text_box.h"

#include "inkcell/layout/text_box.hpp"
#include "layouts.hpp"

using namespace inkcell;
using c::code;
using c::cpp;
using c::text_of;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_text_box_t> {
  using Type = TextBox;
};
template <>
struct CppOf<inkcell_text_place_t> {
  using Type = TextPlace;
};
template <>
struct CppOf<inkcell_text_size_t> {
  using Type = TextSize;
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_VALUE(INKCELL_VERTICAL_TOP, VerticalAlign::top);
INKCELL_SAME_VALUE(INKCELL_VERTICAL_MIDDLE, VerticalAlign::middle);
INKCELL_SAME_VALUE(INKCELL_VERTICAL_OPTICAL, VerticalAlign::optical);
INKCELL_SAME_VALUE(INKCELL_VERTICAL_BOTTOM, VerticalAlign::bottom);
// As in layout.cpp.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
INKCELL_SAME_PLACE(inkcell_text_box_t, layout, options);
INKCELL_SAME_PLACE(inkcell_text_box_t, rect, rect);
INKCELL_SAME_PLACE(inkcell_text_box_t, vertical, vertical);
#pragma GCC diagnostic pop
INKCELL_SAME_PLACE(inkcell_text_place_t, offset, offset);
INKCELL_SAME_PLACE(inkcell_text_place_t, is_line_end, is_line_end);
INKCELL_SAME_PLACE(inkcell_text_size_t, width_q6, width);
INKCELL_SAME_PLACE(inkcell_text_size_t, height_q6, height);
INKCELL_SAME_PLACE(inkcell_text_size_t, lines, lines);

void inkcell_text_box_init(inkcell_text_box_t* box,
                           const inkcell_font_t* font,
                           const inkcell_style_t* style,
                           const inkcell_rect_t* rect) {
  *cpp(box) = TextBox(*cpp(font), *cpp(style), *cpp(rect));
}

inkcell_status_t inkcell_text_box_lay_out(const inkcell_text_box_t* box,
                                          const char* text,
                                          size_t size,
                                          inkcell_line_t* out,
                                          size_t capacity,
                                          size_t* count) {
  Span<const TextLine> lines;
  const Status status =
      cpp(box)->lay_out(text_of(text, size), {cpp(out), capacity}, lines);
  *count = lines.size;
  return code(status);
}

void inkcell_text_box_draw(const inkcell_text_box_t* box,
                           const char* text,
                           size_t size,
                           const inkcell_sink_t* sink,
                           const inkcell_workspace_t* ram,
                           const inkcell_line_t* lines,
                           size_t line_count) {
  cpp(box)->draw(text_of(text, size), *cpp(sink), c::workspace_of(ram),
                 {cpp(lines), line_count});
}

void inkcell_text_box_measure(const inkcell_text_box_t* box,
                              const char* text,
                              size_t size,
                              const inkcell_line_t* lines,
                              size_t line_count,
                              inkcell_text_size_t* out) {
  *cpp(out) = cpp(box)->measure(text_of(text, size), {cpp(lines), line_count});
}

void inkcell_text_box_hit(const inkcell_text_box_t* box,
                          const char* text,
                          size_t size,
                          int32_t x,
                          int32_t y,
                          const inkcell_line_t* lines,
                          size_t line_count,
                          inkcell_text_place_t* out) {
  *cpp(out) =
      cpp(box)->hit(text_of(text, size), x, y, {cpp(lines), line_count});
}

void inkcell_text_box_caret(const inkcell_text_box_t* box,
                            const char* text,
                            size_t size,
                            const inkcell_text_place_t* place,
                            const inkcell_line_t* lines,
                            size_t line_count,
                            inkcell_rect_t* out) {
  *cpp(out) = cpp(box)->caret(text_of(text, size), *cpp(place),
                              {cpp(lines), line_count});
}
