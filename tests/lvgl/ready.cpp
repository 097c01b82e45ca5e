// The program of docs/DRAW.md, "With LVGL": a label in a font that is ready.
#include "example.h"

#include <fonts/dejavu_sans_latin1.hpp>

#include <inkcell/lvgl/inkcell_lvgl.h>
#include <lvgl.h>

static inkcell_lv_font_t text_font;
static inkcell_lv_fit_t text_fit;
static inkcell_lv_cache_t cache;
static void* ram[8192 / sizeof(void*)];

// Call it after lv_init() and lv_display_create().
bool show_kitchen() {
  const void* const rom = fonts::dejavu_sans_latin1;
  const size_t rom_bytes = sizeof fonts::dejavu_sans_latin1;
  if (inkcell_lv_font_init(&text_font, rom, rom_bytes, 14 * 64) !=
          LV_RESULT_OK ||
      inkcell_lv_font_fit_heights(&text_font, &text_fit) != LV_RESULT_OK ||
      inkcell_lv_cache_init(&cache, ram, sizeof ram, 1) != LV_RESULT_OK) {
    return false;
  }
  inkcell_lv_font_set_cache(&text_font, &cache);
  lv_obj_t* const label = lv_label_create(lv_screen_active());
  lv_label_set_text(label, "Kitchen 21.5 \u00B0C");
  lv_obj_set_style_text_font(label, &text_font.lv, 0);
  return true;
}
