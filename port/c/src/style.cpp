// Styles, but for fitting and effects.
#include "inkcell/c/style.h"

#include "filter_parts.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::code;
using c::cpp;
using c::table_of;

namespace {

// The second half of a make(); empty where the first one failed.
inkcell_status_t finish(Status status,
                        const inkcell_filter_t* filter,
                        inkcell_style_t* out) noexcept {
  if (status == Status::ok) {
    cpp(out)->set_painter(c::painter_of(filter));
  } else {
    *cpp(out) = Style();
  }
  return code(status);
}

}  // namespace

inkcell_status_t inkcell_style_make(int32_t size_q6,
                                    const inkcell_filter_t* filter,
                                    inkcell_style_t* out) {
  return finish(Style::make_upright(Q26_6::from_raw(size_q6), table_of(filter),
                                    *cpp(out)),
                filter, out);
}

inkcell_status_t inkcell_style_make_turned(int32_t size_q6,
                                           const inkcell_filter_t* filter,
                                           int32_t cosine_q30,
                                           int32_t sine_q30,
                                           inkcell_style_t* out) {
  const Direction direction = {Fixed<int32_t, 30>::from_raw(cosine_q30),
                               Fixed<int32_t, 30>::from_raw(sine_q30)};
  return finish(Style::make_turned(Q26_6::from_raw(size_q6), table_of(filter),
                                   direction, *cpp(out)),
                filter, out);
}

inkcell_status_t inkcell_style_make_mapped(const inkcell_matrix_t* matrix,
                                           const inkcell_filter_t* filter,
                                           inkcell_style_t* out) {
  const Matrix same = {Q16_16::from_raw(matrix->x_right_q16),
                       Q16_16::from_raw(matrix->x_up_q16),
                       Q16_16::from_raw(matrix->y_right_q16),
                       Q16_16::from_raw(matrix->y_up_q16)};
  return finish(Style::make_mapped(same, table_of(filter), *cpp(out)), filter,
                out);
}

int32_t inkcell_style_size(const inkcell_style_t* style) {
  return cpp(style)->size().raw;
}

inkcell_status_t inkcell_style_check_effect(const inkcell_style_t* style,
                                            const inkcell_font_t* font) {
  return code(check_effect(*cpp(font), *cpp(style)));
}

void inkcell_style_clear_effect(inkcell_style_t* style) {
  cpp(style)->set_effect({});
}
