// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_text_box_init(inkcell_text_box_t* box,
                           const inkcell_font_t* font,
                           const inkcell_style_t* style,
                           const inkcell_rect_t* rect) {
  ref(box) = TextBox(ref(font), ref(style), ref(rect));
}

inkcell_status_t inkcell_text_box_lay_out(const inkcell_text_box_t* box,
                                          const inkcell_painter_t* painter,
                                          const char* text,
                                          size_t size,
                                          inkcell_text_line_t* out,
                                          size_t capacity,
                                          size_t* count) {
  Span<const TextLine> lines;
  const Status status = ref(box).lay_out(text_of(text, size),
      painter_of(painter), {cpp(out), capacity}, lines);
  *count = lines.size;
  return code(status);
}

void inkcell_text_box_draw(const inkcell_text_box_t* box,
                           const inkcell_painter_t* painter,
                           const char* text,
                           size_t size,
                           const inkcell_text_line_t* lines,
                           size_t line_count) {
  ref(box).draw(text_of(text, size), painter_of(painter), {cpp(lines),
      line_count});
}

void inkcell_text_box_box(const inkcell_text_box_t* box,
                          const inkcell_painter_t* painter,
                          const char* text,
                          size_t size,
                          const inkcell_text_line_t* lines,
                          size_t line_count,
                          inkcell_rect_t* out) {
  ref(out) = ref(box).box(text_of(text, size), painter_of(painter), {cpp(lines),
      line_count});
}

void inkcell_text_box_measure(const inkcell_text_box_t* box,
                              const inkcell_painter_t* painter,
                              const char* text,
                              size_t size,
                              const inkcell_text_line_t* lines,
                              size_t line_count,
                              inkcell_text_size_t* out) {
  ref(out) = ref(box).measure(text_of(text, size), painter_of(painter),
      {cpp(lines), line_count});
}

void inkcell_text_box_hit(const inkcell_text_box_t* box,
                          const inkcell_painter_t* painter,
                          const char* text,
                          size_t size,
                          int32_t x,
                          int32_t y,
                          const inkcell_text_line_t* lines,
                          size_t line_count,
                          inkcell_text_place_t* out) {
  ref(out) = ref(box).hit(text_of(text, size), painter_of(painter), x, y,
      {cpp(lines), line_count});
}

void inkcell_text_box_caret(const inkcell_text_box_t* box,
                            const inkcell_painter_t* painter,
                            const char* text,
                            size_t size,
                            const inkcell_text_place_t* place,
                            const inkcell_text_line_t* lines,
                            size_t line_count,
                            inkcell_rect_t* out) {
  ref(out) = ref(box).caret(text_of(text, size), painter_of(painter),
      ref(place), {cpp(lines), line_count});
}

inkcell_status_t inkcell_scrolling_label_make(
    const inkcell_layout_options_t* options,
    const inkcell_painter_t* painter,
    const char* text,
    size_t size,
    const inkcell_rect_t* window,
    inkcell_positioned_glyph_t* room,
    size_t capacity,
    inkcell_scrolling_label_t* out) {
  ref(out) = {};
  return code(ScrollingLabel::make(ref(options), painter_of(painter),
      text_of(text, size), ref(window), {cpp(room), capacity}, ref(out)));
}

int32_t inkcell_scrolling_label_width(const inkcell_scrolling_label_t* label) {
  return ref(label).width().raw;
}

bool inkcell_scrolling_label_needs_scrolling(
    const inkcell_scrolling_label_t* label) {
  return ref(label).needs_scrolling();
}

void inkcell_scrolling_label_draw(const inkcell_scrolling_label_t* label,
                                  const inkcell_painter_t* painter,
                                  int32_t scroll_q6) {
  ref(label).draw(Q26_6::from_raw(scroll_q6), painter_of(painter));
}

void inkcell_scrolling_label_draw_endless(
    const inkcell_scrolling_label_t* label,
    const inkcell_painter_t* painter,
    int32_t scroll_q6,
    int32_t gap_q6) {
  ref(label).draw_endless(Q26_6::from_raw(scroll_q6), Q26_6::from_raw(gap_q6),
      painter_of(painter));
}
