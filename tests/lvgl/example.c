// Fonts of LVGL, compiled as C.
#include "example.h"

#include "inkcell/lvgl/inkcell_lvgl.h"

static lv_result_t label(const void* rom, size_t rom_bytes) {
  static inkcell_lv_font_t text_font;
  static inkcell_lv_fit_t text_fit;
  static inkcell_lv_cache_t cache;
  static void* ram[8192 / sizeof(void*)];
  if (inkcell_lv_font_init(&text_font, rom, rom_bytes, 14 * 64) !=
          LV_RESULT_OK ||
      inkcell_lv_font_fit_heights(&text_font, &text_fit) != LV_RESULT_OK ||
      inkcell_lv_cache_init(&cache, ram, sizeof ram, 1) != LV_RESULT_OK) {
    return LV_RESULT_INVALID;
  }
  inkcell_lv_font_set_cache(&text_font, &cache);
  lv_obj_t* label = lv_label_create(lv_screen_active());
  lv_label_set_text(label, "Kitchen 21.5");
  lv_obj_set_style_text_font(label, &text_font.lv, 0);
  return LV_RESULT_OK;
}

static lv_result_t clock_digits(const void* rom, size_t rom_bytes) {
  static inkcell_lv_font_t digit_font;
  if (inkcell_lv_font_init(&digit_font, rom, rom_bytes, 60 * 64) !=
      LV_RESULT_OK) {
    return LV_RESULT_INVALID;
  }
  inkcell_lv_font_set_direct(&digit_font);
  lv_obj_t* digits = lv_label_create(lv_screen_active());
  lv_label_set_text(digits, "12:34");
  lv_obj_set_style_text_font(digits, &digit_font.lv, 0);
  lv_obj_set_y(digits, 24);
  return LV_RESULT_OK;
}

bool show_example(const void* rom, size_t rom_bytes) {
  return label(rom, rom_bytes) == LV_RESULT_OK &&
         clock_digits(rom, rom_bytes) == LV_RESULT_OK;
}
