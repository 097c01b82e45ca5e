// Grid fitting: of style.h.
#include "inkcell/fit.hpp"

#include "inkcell/c/style.h"
#include "mirror.hpp"

using namespace inkcell;
using c::code;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_fit_t> {
  using Type = Fit;
};
}  // namespace c
}  // namespace inkcell

inkcell_status_t inkcell_fit_make(const inkcell_font_t* font,
                                  const inkcell_style_t* style,
                                  bool across,
                                  uint8_t levels,
                                  uint16_t strength_q8,
                                  inkcell_fit_t* out) {
  FitOptions options;
  options.across = across;
  options.levels = levels;
  options.strength_q8 = strength_q8;
  *cpp(out) = Fit();
  return code(Fit::make(*cpp(font), *cpp(style), options, *cpp(out)));
}

bool inkcell_fit_has_advances(const inkcell_fit_t* fit) {
  return cpp(fit)->has_advances();
}

int16_t inkcell_fit_crisp_weight(const inkcell_fit_t* fit) {
  return cpp(fit)->bilevel_weight().raw;
}

void inkcell_style_set_fit(inkcell_style_t* style, const inkcell_fit_t* fit) {
  cpp(style)->set_fitter(&kGridFit, cpp(fit));
}

void inkcell_style_set_fit_heights(inkcell_style_t* style,
                                   const inkcell_fit_t* fit) {
  cpp(style)->set_fitter(&kFitHeights, cpp(fit));
}

void inkcell_style_clear_fit(inkcell_style_t* style) {
  cpp(style)->set_fitter(nullptr, nullptr);
}
