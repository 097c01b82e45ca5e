// Styles, but for fitting and effects.
#include "inkcell/c/style.h"

#include "mirror.hpp"

using namespace inkcell;
using c::code;
using c::cpp;
using c::filter_of;

namespace {

// A style if its stretches are in range, else one that draws nothing.
template <typename... What>
inkcell_status_t make(inkcell_style_t* out,
                      bool is_allowed,
                      const What&... what) noexcept {
  if (!is_allowed) {
    *out = {};
    return INKCELL_BAD_ARGUMENT;
  }
  *cpp(out) = Style(what...);
  return INKCELL_OK;
}

bool is_size(int32_t size_q6) noexcept {
  return size_q6 >= kMinSize.raw && size_q6 <= kMaxSize.raw;
}

// Whether the length is 1 within 1/1000.
bool is_unit(int64_t cosine_q30, int64_t sine_q30) noexcept {
  constexpr int64_t kOne = int64_t{1} << 30;
  cosine_q30 >>= 1;
  sine_q30 >>= 1;
  const int64_t squared = (cosine_q30 * cosine_q30 + sine_q30 * sine_q30) >> 28;
  return squared >= kOne - kOne / 500 && squared <= kOne + kOne / 500;
}

}  // namespace

inkcell_status_t inkcell_style_make(int32_t size_q6,
                                    const inkcell_filter_t* filter,
                                    inkcell_style_t* out) {
  return make(out, is_size(size_q6), Q26_6::from_raw(size_q6),
              filter_of(filter));
}

inkcell_status_t inkcell_style_make_turned(int32_t size_q6,
                                           const inkcell_filter_t* filter,
                                           int32_t cosine_q30,
                                           int32_t sine_q30,
                                           inkcell_style_t* out) {
  const Direction direction = {Fixed<int32_t, 30>::from_raw(cosine_q30),
                               Fixed<int32_t, 30>::from_raw(sine_q30)};
  return make(out, is_size(size_q6) && is_unit(cosine_q30, sine_q30),
              Q26_6::from_raw(size_q6), filter_of(filter), direction);
}

inkcell_status_t inkcell_style_make_mapped(const inkcell_matrix_t* matrix,
                                           const inkcell_filter_t* filter,
                                           inkcell_style_t* out) {
  const Matrix same = {Q16_16::from_raw(matrix->x_right_q16),
                       Q16_16::from_raw(matrix->x_up_q16),
                       Q16_16::from_raw(matrix->y_right_q16),
                       Q16_16::from_raw(matrix->y_up_q16)};
  return make(out, stretch_of(same).is_in_range(), same, filter_of(filter));
}

int32_t inkcell_style_size(const inkcell_style_t* style) {
  return cpp(style)->size().raw;
}

inkcell_status_t inkcell_style_check_effect(const inkcell_style_t* style,
                                            const inkcell_font_t* font) {
  return code(cpp(font)->check(*cpp(style)));
}

void inkcell_style_clear_effect(inkcell_style_t* style) {
  cpp(style)->clear_effect();
}
