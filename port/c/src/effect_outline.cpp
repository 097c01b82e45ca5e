// Outlines, alone and with their fill: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/effects.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_outline_t> {
  using Type = Outline;
};
template <>
struct CppOf<inkcell_outline_and_fill_t> {
  using Type = OutlineAndFill;
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_VALUE(INKCELL_OUTLINE_INNER, OutlinePlace::inner);
INKCELL_SAME_VALUE(INKCELL_OUTLINE_CENTRED, OutlinePlace::centred);
INKCELL_SAME_VALUE(INKCELL_OUTLINE_OUTER, OutlinePlace::outer);
INKCELL_SAME_PLACE(inkcell_outline_t, outer, outer);
INKCELL_SAME_PLACE(inkcell_outline_t, inner, inner);
INKCELL_SAME_PLACE(inkcell_outline_and_fill_t, inner, inner);
INKCELL_SAME_PLACE(inkcell_outline_and_fill_t, fill, fill);

void inkcell_outline_make(const inkcell_filter_t* edge,
                          int16_t width_q10,
                          uint8_t place,
                          inkcell_outline_t* outline,
                          inkcell_filter_t* outer) {
  new (c::place(outline))
      Outline(make_outline(c::filter_of(edge), Q6_10::from_raw(width_q10),
                           static_cast<OutlinePlace>(place)));
  *outer = {&outline->outer};
}

void inkcell_style_set_outline(inkcell_style_t* style,
                               const inkcell_outline_t* outline) {
  cpp(style)->set_effect(outline_effect(cpp(outline)->inner));
}

void inkcell_style_set_outline_and_fill(inkcell_style_t* style,
                                        const inkcell_outline_t* outline,
                                        inkcell_outline_and_fill_t* both) {
  both->inner = &outline->inner;
  cpp(style)->set_effect(outline_and_fill_effect(*cpp(both)));
}
