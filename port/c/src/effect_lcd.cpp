// Sub-pixels: of effects.h.
#include "inkcell/c/effects.h"
#include "inkcell/lcd.hpp"
#include "mirror.hpp"

using namespace inkcell;
using c::cpp;

INKCELL_SAME_VALUE(INKCELL_SUB_PIXELS_RGB, SubPixels::rgb);
INKCELL_SAME_VALUE(INKCELL_SUB_PIXELS_BGR, SubPixels::bgr);
INKCELL_SAME_VALUE(INKCELL_SUB_PIXELS_RGB_VERTICAL, SubPixels::rgb_vertical);
INKCELL_SAME_VALUE(INKCELL_SUB_PIXELS_BGR_VERTICAL, SubPixels::bgr_vertical);

void inkcell_style_set_lcd(inkcell_style_t* style,
                           inkcell_lcd_options_t* options) {
  cpp(style)->set_effect(*new (c::memory<Lcd>(options->effect)) Lcd(
      static_cast<SubPixels>(options->order), options->colour));
}
