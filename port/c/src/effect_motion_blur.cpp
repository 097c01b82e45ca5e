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
  constexpr int32_t kMost = MotionBlur::kMost.raw;
  if (way_x_q6 < -kMost || way_x_q6 > kMost || way_y_q6 < -kMost ||
      way_y_q6 > kMost) {
    return INKCELL_BAD_ARGUMENT;
  }
  new (c::place(out)) MotionBlur(c::point_of(way_x_q6, way_y_q6));
  return INKCELL_OK;
}

void inkcell_style_set_motion_blur(inkcell_style_t* style,
                                   const inkcell_motion_blur_t* options) {
  cpp(style)->set_effect(*cpp(options));
}
