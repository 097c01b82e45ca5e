// The functions of Adafruit_SSD1306 that text needs, likewise.
#pragma once

#include <Adafruit_GFX.h>
#include <Wire.h>

#define SSD1306_BLACK 0
#define SSD1306_WHITE 1
#define SSD1306_SWITCHCAPVCC 0x02

class Adafruit_SSD1306 : public Adafruit_GFX {
 public:
  Adafruit_SSD1306(uint8_t w, uint8_t h, TwoWire*, int) : Adafruit_GFX(w, h) {}
  bool begin(int, int) { return true; }
  void display() {}
  void clearDisplay() { memset(pages_, 0, sizeof pages_); }
  uint8_t* getBuffer() { return pages_; }
  void drawPixel(int16_t x, int16_t y, uint16_t colour) override {
    uint8_t& byte = pages_[y / 8 * 128 + x];
    const int bit = 1 << y % 8;
    byte = static_cast<uint8_t>(colour ? byte | bit : byte & ~bit);
  }

 private:
  uint8_t pages_[128 * 64 / 8];
};
