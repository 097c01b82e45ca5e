// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_circle_samples_make(const inkcell_filter_t* filter,
                                 int16_t radius_q10,
                                 bool is_paper,
                                 inkcell_circle_samples_t* out) {
  new (into(out)) CircleSamples(filter_of(filter), Q6_10::from_raw(radius_q10),
      is_paper ? SampleRule::paper : SampleRule::even);
}

void inkcell_style_set_circle_samples(inkcell_style_t* style,
                                      const inkcell_circle_samples_t* options) {
  ref(style).set_effect(ref(options));
}
