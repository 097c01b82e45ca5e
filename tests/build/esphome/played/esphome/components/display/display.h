// What a font needs of ESPHome's display and colour, for where its sources are
// absent.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace esphome {

struct Color {
  uint8_t r = 0, g = 0, b = 0;
  Color() {}
  Color(uint8_t red, uint8_t green, uint8_t blue) : r(red), g(green), b(blue) {}
};

namespace display {

enum class DisplayType {
  DISPLAY_TYPE_BINARY = 1,
  DISPLAY_TYPE_GRAYSCALE = 2,
  DISPLAY_TYPE_COLOR = 3,
};

class Display {
 public:
  virtual DisplayType get_display_type() = 0;
  virtual int get_width() = 0;
  virtual int get_height() = 0;
  virtual void draw_pixel_at(int x, int y, Color color) = 0;
};

class BaseFont {
 public:
  virtual void print(int x,
                     int y,
                     Display* display,
                     Color color,
                     const char* text,
                     Color background) = 0;
  virtual void measure(const char* str,
                       int* width,
                       int* x_offset,
                       int* baseline,
                       int* height) = 0;
};

}  // namespace display
}  // namespace esphome
