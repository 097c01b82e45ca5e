// Contrast at small sizes: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/edge_contrast.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

void inkcell_style_set_edge_contrast(inkcell_style_t* style,
                                     inkcell_edge_contrast_t* options) {
  cpp(style)->set_effect(*new (c::memory<EdgeContrast>(options->effect))
                             EdgeContrast(options->edge, options->thin));
}
