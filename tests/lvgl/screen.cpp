#include "screen.hpp"

#include <string.h>

Screen::Screen(int32_t width,
               int32_t height,
               lv_color_format_t format,
               int32_t rows) {
  lv_init();
  pixel_bytes_ = lv_color_format_get_size(format);
  row_bytes_ = width * pixel_bytes_;
  picture_.resize(static_cast<size_t>(row_bytes_ * height));
  const auto stride =
      lv_draw_buf_width_to_stride(static_cast<uint32_t>(width), format);
  strip_.resize(stride * static_cast<uint32_t>(rows) / 4 + 1);
  display_ = lv_display_create(width, height);
  lv_display_set_color_format(display_, format);
  lv_display_set_buffers(display_, strip_.data(), nullptr,
                         stride * static_cast<uint32_t>(rows),
                         LV_DISPLAY_RENDER_MODE_PARTIAL);
  lv_display_set_user_data(display_, this);
  lv_display_set_flush_cb(display_, flush);
}

Screen::~Screen() {
  lv_deinit();
}

void Screen::add(const Look& look) {
  lv_obj_t* screen = lv_screen_active();
  lv_obj_set_style_bg_color(screen, lv_color_hex(look.background), 0);
  lv_obj_set_style_bg_opa(screen, LV_OPA_COVER, 0);
  lv_obj_t* label = lv_label_create(screen);
  lv_label_set_text_static(label, look.text);
  lv_obj_set_pos(label, look.x, look.y);
  lv_obj_set_style_text_font(label, look.font, 0);
  lv_obj_set_style_text_color(label, lv_color_hex(look.colour), 0);
  lv_obj_set_style_text_opa(label, look.opacity, 0);
  lv_obj_set_style_transform_rotation(label, look.rotation, 0);
}

const std::vector<uint8_t>& Screen::draw() {
  lv_obj_invalidate(lv_screen_active());
  lv_refr_now(display_);
  return picture_;
}

void Screen::flush(lv_display_t* display,
                   const lv_area_t* area,
                   uint8_t* pixels) {
  auto& self = *static_cast<Screen*>(lv_display_get_user_data(display));
  const int32_t width = lv_area_get_width(area);
  const auto stride = lv_draw_buf_width_to_stride(
      static_cast<uint32_t>(width), lv_display_get_color_format(display));
  for (int32_t y = area->y1; y <= area->y2; ++y) {
    memcpy(&self.picture_[static_cast<size_t>(y * self.row_bytes_ +
                                              area->x1 * self.pixel_bytes_)],
           pixels + static_cast<uint32_t>(y - area->y1) * stride,
           static_cast<size_t>(width * self.pixel_bytes_));
  }
  lv_display_flush_ready(display);
}
