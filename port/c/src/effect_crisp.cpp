// Text for 1 and 2 bits: of effects.h.
#include "inkcell/bilevel.hpp"
#include "inkcell/c/effects.h"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

void inkcell_style_set_crisp(inkcell_style_t* style,
                             inkcell_crisp_options_t* options) {
  cpp(style)->set_effect(*new (c::memory<Bilevel>(options->effect)) Bilevel(
      options->levels, Q6_10::from_raw(options->threshold_q10)));
}
