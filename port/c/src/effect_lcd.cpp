// Sub-pixels: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/lcd.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

namespace inkcell {
namespace c {
template <>
struct CppOf<inkcell_lcd_options_t> {
  using Type = LcdOptions;
};
}  // namespace c
}  // namespace inkcell

INKCELL_SAME_VALUE(INKCELL_SUB_PIXELS_RGB, SubPixels::rgb);
INKCELL_SAME_VALUE(INKCELL_SUB_PIXELS_BGR, SubPixels::bgr);
INKCELL_SAME_VALUE(INKCELL_SUB_PIXELS_RGB_VERTICAL, SubPixels::rgb_vertical);
INKCELL_SAME_VALUE(INKCELL_SUB_PIXELS_BGR_VERTICAL, SubPixels::bgr_vertical);
INKCELL_SAME_PLACE(inkcell_lcd_options_t, order, order);
INKCELL_SAME_PLACE(inkcell_lcd_options_t, colour, colour);

void inkcell_style_set_lcd(inkcell_style_t* style,
                           const inkcell_lcd_options_t* options) {
  cpp(style)->set_effect(lcd_effect(*cpp(options)));
}
