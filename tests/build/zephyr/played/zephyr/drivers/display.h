// Likewise.
#pragma once

#include <zephyr/device.h>

enum display_pixel_format {
  PIXEL_FORMAT_MONO01 = 1 << 1,
  PIXEL_FORMAT_RGB_565 = 1 << 4,
  PIXEL_FORMAT_BGR_565 = 1 << 5
};
struct display_capabilities {
  uint16_t x_resolution, y_resolution;
  enum display_pixel_format current_pixel_format;
};
struct display_buffer_descriptor {
  uint32_t buf_size;
  uint16_t width, height, pitch;
};
void display_get_capabilities(const struct device*,
                              struct display_capabilities*);
int display_blanking_off(const struct device*);
int display_write(const struct device*,
                  uint16_t x,
                  uint16_t y,
                  const struct display_buffer_descriptor*,
                  const void* pixels);
