// A colour panel that nobody can read but the test.
#pragma once

#include <Adafruit_GFX.h>

class Adafruit_ST7789 : public Adafruit_GFX {
 public:
  Adafruit_ST7789(int, int, int) : Adafruit_GFX(240, 240) {}
  void init(int, int) {}
  void drawPixel(int16_t x, int16_t y, uint16_t colour) override {
    memory[y * 240 + x] = colour;
  }

  uint16_t memory[240 * 240];
};
