// Runs the sample of Zephyr twice around: the panel must show the picture of
// the whole screen.
#define main sample_main
#include "main.cpp"
#undef main
#include "panel.hpp"

const struct device chosen_zephyr_display = {0};
static display_pixel_format format = PIXEL_FORMAT_MONO01;

bool device_is_ready(const struct device*) {
  return true;
}
void display_get_capabilities(const struct device*,
                              struct display_capabilities* out) {
  out->x_resolution = out->y_resolution = 240;
  out->current_pixel_format = format;
}
int display_blanking_off(const struct device*) {
  return 0;
}
int display_write(const struct device*,
                  uint16_t x,
                  uint16_t y,
                  const struct display_buffer_descriptor* rows,
                  const void* from) {
  const auto* const bytes = static_cast<const uint8_t*>(from);
  for (int i = 0; i < rows->width * rows->height; ++i, ++pixels_sent) {
    const int row = i / rows->width;
    const int column = i % rows->width;
    const int byte = 2 * (row * rows->pitch + column);
    if (static_cast<uint32_t>(byte) + 1 >= rows->buf_size) {
      return -22;
    }
    panel[(y + row) * 240 + x + column] =
        static_cast<uint16_t>(bytes[byte] << 8 | bytes[byte + 1]);
  }
  return 0;
}

int32_t k_msleep(int32_t) {
  check_round();
  return 0;
}

int main() {
  if (sample_main() != static_cast<int>(Status::unsupported)) {
    return 2;  // a display of 1 bit is refused
  }
  format = PIXEL_FORMAT_RGB_565;
  return sample_main() - 1000;
}
