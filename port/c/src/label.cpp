// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_label_make(const inkcell_layout_t* layout,
                                    const char* text,
                                    size_t size,
                                    const inkcell_rect_t* window,
                                    inkcell_positioned_glyph_t* room,
                                    size_t capacity,
                                    inkcell_label_t* out) {
  ref(out) = ScrollingLabel();
  return code(ScrollingLabel::make(ref(layout), text_of(text, size),
      ref(window), {cpp(room), capacity}, ref(out)));
}

int32_t inkcell_label_width(const inkcell_label_t* label) {
  return ref(label).width().raw;
}

bool inkcell_label_needs_scrolling(const inkcell_label_t* label) {
  return ref(label).needs_scrolling();
}

void inkcell_label_draw(const inkcell_label_t* label,
                        int32_t scroll_q6,
                        const inkcell_sink_t* sink,
                        const inkcell_workspace_t* ram) {
  ref(label).draw(Q26_6::from_raw(scroll_q6), ref(sink), workspace_of(ram));
}

void inkcell_label_draw_endless(const inkcell_label_t* label,
                                int32_t scroll_q6,
                                int32_t gap_q6,
                                const inkcell_sink_t* sink,
                                const inkcell_workspace_t* ram) {
  ref(label).draw_endless(Q26_6::from_raw(scroll_q6), Q26_6::from_raw(gap_q6),
      ref(sink), workspace_of(ram));
}
