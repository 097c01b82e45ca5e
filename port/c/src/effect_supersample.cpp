// Several samples a pixel: of effects.h.
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

INKCELL_SAME_PLACE(inkcell_supersampling_t, radius_q10, radius_q10);

void inkcell_style_set_supersampling(inkcell_style_t* style,
                                     const inkcell_supersampling_t* options) {
  cpp(style)->set_effect(supersample_effect(*cpp(options)));
}
