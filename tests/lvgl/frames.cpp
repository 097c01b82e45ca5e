// Draws a label again and again, to count instructions: the difference of two
// runs is that of the frames between them.
//
//   inkcell_lvgl_frames conv|bitmap|fitted|direct|cached|blank 14|28 FRAMES
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fonts/lv_sans.hpp"
#include "inkcell/lvgl/inkcell_lvgl.h"
#include "screen.hpp"

LV_FONT_DECLARE(lv_conv_14)
LV_FONT_DECLARE(lv_conv_28)

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: inkcell_lvgl_frames FONT SIZE FRAMES\n");
    return 2;
  }
  const std::string kind = argv[1];
  const int size_px = std::atoi(argv[2]);
  static inkcell_lv_font_t font;
  static inkcell_lv_fit_t fit;
  static inkcell_lv_cache_t cache;
  alignas(8) static uint8_t ram[16384];
  if (inkcell_lv_font_init(&font, fonts::lv_sans, sizeof fonts::lv_sans,
                           size_px * 64) != LV_RESULT_OK) {
    return 1;
  }
  Screen screen(320, 40, LV_COLOR_FORMAT_RGB565, 40);
  Look look;
  look.font = &font.lv;
  look.text = "Kitchen 21.5 \xc3\xa4";
  if (kind == "conv") {
    look.font = size_px == 14 ? &lv_conv_14 : &lv_conv_28;
  } else if (kind == "fitted") {
    static_cast<void>(inkcell_lv_font_fit_heights(&font, &fit));
  } else if (kind == "direct") {
    inkcell_lv_font_set_direct(&font);
  } else if (kind == "cached") {
    inkcell_lv_font_set_direct(&font);
    static_cast<void>(inkcell_lv_cache_init(&cache, ram, sizeof ram, 1));
    inkcell_lv_font_set_cache(&font, &cache);
  } else if (kind == "blank") {
    look.text = "";
  } else if (kind != "bitmap") {
    std::fprintf(stderr, "inkcell_lvgl_frames: no font '%s'\n", argv[1]);
    return 2;
  }
  screen.add(look);
  for (int i = 0; i < std::atoi(argv[3]); ++i) {
    screen.draw();
  }
  return 0;
}
