// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

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
  ref(out) = Fit();
  return code(Fit::make(ref(font), ref(style), options, ref(out)));
}

bool inkcell_fit_has_advances(const inkcell_fit_t* fit) {
  return ref(fit).has_advances();
}

int16_t inkcell_fit_bilevel_weight(const inkcell_fit_t* fit) {
  return ref(fit).bilevel_weight().raw;
}

void inkcell_style_set_fit(inkcell_style_t* style, const inkcell_fit_t* fit) {
  ref(style).set_fitter(&kGridFit, cpp(fit));
}

void inkcell_style_set_fit_heights(inkcell_style_t* style,
                                   const inkcell_fit_t* fit) {
  ref(style).set_fitter(&kFitHeights, cpp(fit));
}

void inkcell_style_fit_levels(inkcell_style_t* style, uint8_t levels) {
  ref(style).set_fitter(levels == 2 ? &kFitTwoLevels : &kFitFourLevels,
      nullptr);
  ref(style).set_effect(levels == 2 ? detail::kTwoLevels : detail::kFourLevels);
}

void inkcell_style_clear_fit(inkcell_style_t* style) {
  ref(style).set_fitter(nullptr, nullptr);
}
