// clang-format off
// Made by port/c/make_api.py from port/c/api.txt: edit that instead.
#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;

void inkcell_style_set_lcd(inkcell_style_t* style,
                           inkcell_lcd_options_t* options) {
  ref(style).set_effect(*new (into_words<Lcd>(options->effect))
      Lcd(static_cast<SubPixels>(options->order), options->colour));
}
