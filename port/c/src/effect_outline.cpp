// Strokes, alone and with their fill: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/stroke.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_outline_t> {
  using Type = Stroke;
};
template <>
struct CppOf<inkcell_outline_and_fill_t> {
  using Type = StrokeAndFill;  // whose last member is the sink as well
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_VALUE(INKCELL_OUTLINE_INNER, StrokePlace::inner);
INKCELL_SAME_VALUE(INKCELL_OUTLINE_CENTRED, StrokePlace::centred);
INKCELL_SAME_VALUE(INKCELL_OUTLINE_OUTER, StrokePlace::outer);

void inkcell_outline_make(const inkcell_filter_t* edge,
                          int16_t width_q10,
                          uint8_t place,
                          inkcell_outline_t* outline,
                          inkcell_filter_t* outer) {
  const Stroke& stroke = *new (c::place(outline)) Stroke(
      c::filter_of(edge), Q6_10::from_raw(width_q10),
      static_cast<StrokePlace>(place));
  *outer = {&stroke.outer};
}

void inkcell_style_set_outline(inkcell_style_t* style,
                               const inkcell_outline_t* outline) {
  cpp(style)->set_effect(*cpp(outline));
}

void inkcell_style_set_outline_and_fill(inkcell_style_t* style,
                                        const inkcell_outline_t* outline,
                                        inkcell_outline_and_fill_t* both) {
  cpp(style)->set_effect(*new (c::place(both))
                             StrokeAndFill(*cpp(outline), cpp(both->fill)));
}
