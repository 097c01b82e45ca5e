// A display of LVGL in memory: labels drawn by LVGL in strips.
#pragma once

#include <stdint.h>

#include <vector>

#include "lvgl.h"

/// What a label is drawn with.
struct Look {
  const lv_font_t* font = nullptr;
  const char* text = "";
  int32_t x = 0;
  int32_t y = 0;
  lv_opa_t opacity = LV_OPA_COVER;
  uint32_t colour = 0x102030;
  uint32_t background = 0xf0e8d0;
  int32_t rotation = 0;  // of the label, through a layer [0.1 degrees]
};

/// A display of `width` x `height` px in one colour format, drawn in strips of
/// `rows` rows. Starts LVGL and ends it: one at a time.
class Screen {
 public:
  Screen(int32_t width, int32_t height, lv_color_format_t format, int32_t rows);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// Adds a label to the screen.
  void add(const Look& look);

  /// Has LVGL draw the whole screen anew: its pixels, row by row, in the
  /// display's colour format.
  const std::vector<uint8_t>& draw();

  int32_t row_bytes() const { return row_bytes_; }

 private:
  static void flush(lv_display_t* display,
                    const lv_area_t* area,
                    uint8_t* pixels);

  int32_t pixel_bytes_;
  int32_t row_bytes_;
  std::vector<uint8_t> picture_;
  std::vector<uint32_t> strip_;
  lv_display_t* display_;
};
