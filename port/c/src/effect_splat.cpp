// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_splats_make(uint32_t* sums,
                                     size_t count,
                                     int16_t radius_q10,
                                     inkcell_splats_t* out) {
  if (count < kMinSplatSums) {
    return INKCELL_BUFFER_SMALL;
  }
  if (radius_q10 < kMinSplatRadius.raw || radius_q10 > kMaxSplatRadius.raw) {
    return INKCELL_BAD_ARGUMENT;
  }
  new (into(out)) Splat(Span<uint32_t>(sums, count),
      Q6_10::from_raw(radius_q10));
  return INKCELL_OK;
}

void inkcell_style_set_splats(inkcell_style_t* style,
                              const inkcell_splats_t* options) {
  ref(style).set_effect(ref(options));
}
