// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_outline_make(const inkcell_filter_t* edge,
                          int16_t width_q10,
                          uint8_t place,
                          inkcell_outline_t* outline,
                          inkcell_filter_t* outer) {
  const Stroke& stroke = *new (into(outline)) Stroke(filter_of(edge),
      Q6_10::from_raw(width_q10),
      static_cast<StrokePlace>(place));
  *outer = {&stroke.outer};
}

void inkcell_style_set_outline(inkcell_style_t* style,
                               const inkcell_outline_t* outline) {
  ref(style).set_effect(ref(outline));
}

void inkcell_style_set_outline_and_fill(inkcell_style_t* style,
                                        const inkcell_outline_t* outline,
                                        inkcell_outline_and_fill_t* both) {
  ref(style).set_effect(*new (into(both)) StrokeAndFill(ref(outline),
      cpp(both->fill)));
}
