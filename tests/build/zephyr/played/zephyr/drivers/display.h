// Likewise.
#pragma once

#include <zephyr/device.h>

struct display_capabilities {
  uint16_t x_resolution, y_resolution;
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
