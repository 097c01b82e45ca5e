// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_motion_blur_make(int32_t way_x_q6,
                                          int32_t way_y_q6,
                                          inkcell_motion_blur_t* out) {
  constexpr int32_t kMost = MotionBlur::kMost.raw;
  if (way_x_q6 < -kMost || way_x_q6 > kMost || way_y_q6 < -kMost || way_y_q6 >
      kMost) {
    return INKCELL_BAD_ARGUMENT;
  }
  new (into(out)) MotionBlur(point_of(way_x_q6, way_y_q6));
  return INKCELL_OK;
}

void inkcell_style_set_motion_blur(inkcell_style_t* style,
                                   const inkcell_motion_blur_t* options) {
  ref(style).set_effect(ref(options));
}
