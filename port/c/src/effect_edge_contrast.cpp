// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_style_set_edge_contrast(inkcell_style_t* style,
                                     inkcell_edge_contrast_t* options) {
  ref(style).set_effect(*new (into_words<EdgeContrast>(options->effect))
      EdgeContrast(options->edge, options->thin));
}
