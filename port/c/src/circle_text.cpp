// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_draw_on_circle(const inkcell_painter_t* painter,
                            const inkcell_font_t* font,
                            const char* text,
                            size_t size,
                            const inkcell_style_t* style,
                            const inkcell_text_circle_t* circle) {
  motion::draw_on_circle(painter_of(painter), ref(font), ref(style),
      ref(circle), text_of(text, size));
}

void inkcell_circle_box(const inkcell_font_t* font,
                        const char* text,
                        size_t size,
                        const inkcell_style_t* style,
                        const inkcell_text_circle_t* circle,
                        inkcell_rect_t* out) {
  ref(out) = motion::draw_on_circle({}, ref(font), ref(style), ref(circle),
      text_of(text, size));
}
