// Contrast at small sizes: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/edge_contrast.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_edge_contrast_t> {
  using Type = EdgeContrast;
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_PLACE(inkcell_edge_contrast_t, edge, edge);
INKCELL_SAME_PLACE(inkcell_edge_contrast_t, thin, thin);

void inkcell_style_set_edge_contrast(inkcell_style_t* style,
                                     const inkcell_edge_contrast_t* options) {
  cpp(style)->set_effect(edge_contrast_effect(*cpp(options)));
}
