// Several samples a pixel of a field: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/field/circle_samples.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_circle_samples_t> {
  using Type = CircleSamples;
};
}  // namespace c
}  // namespace inkcell

void inkcell_circle_samples_make(const inkcell_filter_t* filter,
                                 int16_t radius_q10,
                                 bool is_paper,
                                 inkcell_circle_samples_t* out) {
  new (c::place(out))
      CircleSamples(c::filter_of(filter), Q6_10::from_raw(radius_q10),
                    is_paper ? SampleRule::paper : SampleRule::even);
}

void inkcell_style_set_circle_samples(inkcell_style_t* style,
                                      const inkcell_circle_samples_t* options) {
  cpp(style)->set_effect(*cpp(options));
}
