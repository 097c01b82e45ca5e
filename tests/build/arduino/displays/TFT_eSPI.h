// The functions of TFT_eSPI that text needs: pixels go to a panel of 240 x 240
// in the order of their bytes, unless they are to be swapped.
#pragma once

#include <Arduino.h>

#define TFT_WHITE 0xFFFF
#define TFT_NAVY 0x000F

class TFT_eSPI : public Print {
 public:
  void init() {}
  size_t write(uint8_t) override { return 1; }
  int16_t width() { return 240; }
  int16_t height() { return 240; }
  void setSwapBytes(bool swap) { swap_ = swap; }
  bool getSwapBytes() { return swap_; }
  void fillScreen(uint32_t colour) {
    for (uint16_t& pixel : memory) {
      pixel = static_cast<uint16_t>(colour);
    }
  }
  void fillRect(int32_t x, int32_t y, int32_t w, int32_t h, uint32_t colour) {
    for (int32_t i = 0; i < w * h; ++i) {
      memory[(y + i / w) * 240 + x + i % w] = static_cast<uint16_t>(colour);
    }
  }
  void pushImage(int32_t x, int32_t y, int32_t w, int32_t h, uint16_t* data) {
    const uint8_t* bytes = reinterpret_cast<const uint8_t*>(data);
    for (int32_t i = 0; i < w * h; ++i) {
      const int high = bytes[2 * i + (swap_ ? 1 : 0)];
      const int low = bytes[2 * i + (swap_ ? 0 : 1)];
      memory[(y + i / w) * 240 + x + i % w] =
          static_cast<uint16_t>(high << 8 | low);
    }
  }
  void drawBitmap(
      int16_t, int16_t, const uint8_t*, int16_t, int16_t, uint16_t) {}
  void drawBitmap(
      int16_t, int16_t, const uint8_t*, int16_t, int16_t, uint16_t, uint16_t) {}

  uint16_t memory[240 * 240];

 private:
  bool swap_ = false;
};
