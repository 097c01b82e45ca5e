// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_value_label_init(inkcell_value_label_t* value,
                              const inkcell_font_t* font,
                              const inkcell_style_t* style,
                              int32_t x_q6,
                              int32_t y_q6,
                              uint8_t anchor) {
  ref(value) = ValueLabel(ref(font), ref(style), point_of(x_q6, y_q6),
      static_cast<Anchor>(anchor));
}

void inkcell_value_label_set(inkcell_value_label_t* value,
                             const inkcell_painter_t* painter,
                             const char* text,
                             size_t size,
                             inkcell_rect_t* out) {
  ref(out) = ref(value).set(text_of(text, size), painter_of(painter));
}

void inkcell_value_label_draw(const inkcell_value_label_t* value,
                              const inkcell_painter_t* painter) {
  ref(value).draw(painter_of(painter));
}

const char* inkcell_number_text(int32_t value,
                                int32_t decimals,
                                int32_t digits,
                                char point,
                                char* out) {
  return put_text(NumberText(value, decimals, digits, point), out);
}

const char* inkcell_number_text_of_q16(int32_t value_q16,
                                       int32_t decimals,
                                       int32_t digits,
                                       char point,
                                       char* out) {
  return put_text(NumberText(Q16_16::from_raw(value_q16), decimals, digits,
      point), out);
}

const char* inkcell_number_add_unit(char* number, const char* unit) {
  const Text text = number;
  put_text(cut(unit, INKCELL_NUMBER_BYTES - 1 - text.size), number + text.size);
  return number;
}
