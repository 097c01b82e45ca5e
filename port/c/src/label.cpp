// Lines that scroll: of text_box.h.
#include "inkcell/layout/label.hpp"

#include "inkcell/c/text_box.h"
#include "layouts.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_label_t> {
  using Type = ScrollingLabel;
};
}  // namespace c
}  // namespace inkcell

inkcell_status_t inkcell_label_make(const inkcell_layout_t* layout,
                                    const char* text,
                                    size_t size,
                                    const inkcell_rect_t* window,
                                    inkcell_positioned_glyph_t* room,
                                    size_t capacity,
                                    inkcell_label_t* out) {
  *cpp(out) = ScrollingLabel();
  return c::code(ScrollingLabel::make(*cpp(layout), c::text_of(text, size),
                                      *cpp(window), {cpp(room), capacity},
                                      *cpp(out)));
}

int32_t inkcell_label_width(const inkcell_label_t* label) {
  return cpp(label)->width().raw;
}

bool inkcell_label_needs_scrolling(const inkcell_label_t* label) {
  return cpp(label)->needs_scrolling();
}

void inkcell_label_draw(const inkcell_label_t* label,
                        int32_t scroll_q6,
                        const inkcell_sink_t* sink,
                        const inkcell_workspace_t* ram) {
  cpp(label)->draw(Q26_6::from_raw(scroll_q6), *cpp(sink),
                   c::workspace_of(ram));
}

void inkcell_label_draw_endless(const inkcell_label_t* label,
                                int32_t scroll_q6,
                                int32_t gap_q6,
                                const inkcell_sink_t* sink,
                                const inkcell_workspace_t* ram) {
  cpp(label)->draw_endless(Q26_6::from_raw(scroll_q6), Q26_6::from_raw(gap_q6),
                           *cpp(sink), c::workspace_of(ram));
}
