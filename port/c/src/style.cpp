// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

inkcell_status_t inkcell_style_make(int32_t size_q6,
                                    const inkcell_filter_t* filter,
                                    inkcell_style_t* out) {
  return make_style(out, is_size(size_q6), Q26_6::from_raw(size_q6),
      filter_of(filter));
}

void inkcell_style_for_cap_height(const inkcell_font_t* font,
                                  int32_t height_q6,
                                  const inkcell_filter_t* filter,
                                  inkcell_style_t* out) {
  ref(out) = Style::for_cap_height(ref(font), Q26_6::from_raw(height_q6),
      filter_of(filter));
}

void inkcell_style_for_digit_height(const inkcell_font_t* font,
                                    int32_t height_q6,
                                    const inkcell_filter_t* filter,
                                    inkcell_style_t* out) {
  ref(out) = Style::for_digit_height(ref(font), Q26_6::from_raw(height_q6),
      filter_of(filter));
}

inkcell_status_t inkcell_style_make_turned(int32_t size_q6,
                                           const inkcell_filter_t* filter,
                                           int32_t cosine_q30,
                                           int32_t sine_q30,
                                           inkcell_style_t* out) {
  const Direction direction = {Fixed<int32_t, 30>::from_raw(cosine_q30),
                               Fixed<int32_t, 30>::from_raw(sine_q30)};
  return make_style(out, is_size(size_q6) && is_unit(cosine_q30, sine_q30),
                    Q26_6::from_raw(size_q6), filter_of(filter), direction);
}

inkcell_status_t inkcell_style_make_mapped(const inkcell_matrix_t* matrix,
                                           const inkcell_filter_t* filter,
                                           inkcell_style_t* out) {
  const Matrix same = {Q16_16::from_raw(matrix->x_right_q16),
      Q16_16::from_raw(matrix->x_up_q16),
                       Q16_16::from_raw(matrix->y_right_q16),
      Q16_16::from_raw(matrix->y_up_q16)};
  return make_style(out, stretch_of(same).is_in_range(), same,
      filter_of(filter));
}

int32_t inkcell_style_size(const inkcell_style_t* style) {
  return ref(style).size().raw;
}

void inkcell_style_clear_effect(inkcell_style_t* style) {
  ref(style).clear_effect();
}

inkcell_status_t inkcell_font_check(const inkcell_font_t* font,
                                    const inkcell_style_t* style) {
  return code(ref(font).check(ref(style)));
}

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
  ref(style).set_fit(ref(fit));
}

void inkcell_style_set_fit_heights(inkcell_style_t* style,
                                   const inkcell_fit_t* fit) {
  ref(style).set_fit(kFitHeights, cpp(fit));
}

void inkcell_style_fit_levels(inkcell_style_t* style, uint8_t levels) {
  ref(style).set_fit(levels == 2 ? kFitTwoLevels : kFitFourLevels, nullptr);
  ref(style).set_effect(levels == 2 ? detail::kTwoLevels : detail::kFourLevels);
}

void inkcell_style_clear_fit(inkcell_style_t* style) {
  ref(style).clear_fit();
}
