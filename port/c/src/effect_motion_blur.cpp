// Type that moves while the shutter is open: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/motion_blur.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_motion_blur_t> {
  using Type = MotionBlur;
};
}  // namespace c
}  // namespace inkcell

inkcell_status_t inkcell_motion_blur_make(int32_t way_x_q6,
                                          int32_t way_y_q6,
                                          inkcell_motion_blur_t* out) {
  return c::code(make_motion_blur(c::point_of(way_x_q6, way_y_q6), *cpp(out)));
}

void inkcell_style_set_motion_blur(inkcell_style_t* style,
                                   const inkcell_motion_blur_t* options) {
  cpp(style)->set_effect(motion_blur_effect(*cpp(options)));
}
