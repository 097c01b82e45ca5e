// Several samples a pixel: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/supersample.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

void inkcell_style_set_supersampling(inkcell_style_t* style,
                                     inkcell_supersampling_t* options) {
  cpp(style)->set_effect(*new (c::memory<Supersample>(options->effect))
                             Supersample(Q6_10::from_raw(options->radius_q10)));
}
