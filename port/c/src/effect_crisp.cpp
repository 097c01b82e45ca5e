// Text for 1 and 2 bits: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/crisp.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_crisp_options_t> {
  using Type = CrispOptions;
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_PLACE(inkcell_crisp_options_t, levels, levels);
INKCELL_SAME_PLACE(inkcell_crisp_options_t, threshold_q10, threshold_px);

void inkcell_style_set_crisp(inkcell_style_t* style,
                             const inkcell_crisp_options_t* options) {
  cpp(style)->set_effect(crisp_effect(*cpp(options)));
}
