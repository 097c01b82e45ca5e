// Several samples a pixel: of effects.h.
#include "filter_parts.hpp"
#include "inkcell/c/effects.h"
#include "inkcell/supersample.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_supersampling_t> {
  using Type = Supersampling;
};
}  // namespace c
}  // namespace inkcell

void inkcell_supersampling_make(const inkcell_filter_t* filter,
                                int16_t radius_q10,
                                bool is_paper,
                                inkcell_supersampling_t* out) {
  new (c::place(out)) Supersampling(
      make_supersampling(c::table_of(filter), Q6_10::from_raw(radius_q10),
                         is_paper ? SampleRule::paper : SampleRule::even));
}

void inkcell_style_set_supersampling(inkcell_style_t* style,
                                     const inkcell_supersampling_t* options) {
  cpp(style)->set_effect(supersample_effect(*cpp(options)));
}
