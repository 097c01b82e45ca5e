// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_style_set_bilevel(inkcell_style_t* style,
                               inkcell_bilevel_options_t* options) {
  ref(style).set_effect(*new (into_words<Bilevel>(options->effect))
      Bilevel(options->levels, Q6_10::from_raw(options->threshold_q10)));
}
