// The functions of Adafruit_GFX that text needs, for where its sources are
// absent.
#pragma once

#include <Arduino.h>

class Adafruit_GFX : public Print {
 public:
  Adafruit_GFX(int16_t w, int16_t h) : width_(w), height_(h) {}
  virtual ~Adafruit_GFX() {}
  virtual void drawPixel(int16_t x, int16_t y, uint16_t colour) = 0;
  size_t write(uint8_t) override { return 1; }
  int16_t width() const { return width_; }
  int16_t height() const { return height_; }

  void fillScreen(uint16_t colour) {
    for (int16_t y = 0; y < height_; ++y) {
      for (int16_t x = 0; x < width_; ++x) {
        drawPixel(x, y, colour);
      }
    }
  }
  void drawRGBBitmap(
      int16_t x, int16_t y, uint16_t* from, int16_t w, int16_t h) {
    for (int i = 0; i < w * h; ++i) {
      drawPixel(static_cast<int16_t>(x + i % w),
                static_cast<int16_t>(y + i / w), from[i]);
    }
  }
  void drawBitmap(
      int16_t x, int16_t y, uint8_t* from, int16_t w, int16_t h, uint16_t ink) {
    draw_bits(x, y, from, w, h, ink, nullptr);
  }
  void drawBitmap(int16_t x,
                  int16_t y,
                  uint8_t* from,
                  int16_t w,
                  int16_t h,
                  uint16_t ink,
                  uint16_t paper) {
    draw_bits(x, y, from, w, h, ink, &paper);
  }

 private:
  void draw_bits(int16_t x,
                 int16_t y,
                 const uint8_t* from,
                 int w,
                 int h,
                 uint16_t ink,
                 const uint16_t* paper) {
    for (int row = 0; row < h; ++row) {
      for (int column = 0; column < w; ++column) {
        const int byte = from[row * ((w + 7) / 8) + column / 8];
        if ((byte & 0x80 >> column % 8) != 0) {
          drawPixel(static_cast<int16_t>(x + column),
                    static_cast<int16_t>(y + row), ink);
        } else if (paper != nullptr) {
          drawPixel(static_cast<int16_t>(x + column),
                    static_cast<int16_t>(y + row), *paper);
        }
      }
    }
  }

  int16_t width_, height_;
};

class GFXcanvas16 : public Adafruit_GFX {
 public:
  GFXcanvas16(uint16_t w, uint16_t h)
      : Adafruit_GFX(static_cast<int16_t>(w), static_cast<int16_t>(h)),
        pixels_(static_cast<uint16_t*>(calloc(w * h, 2))) {}
  ~GFXcanvas16() { free(pixels_); }
  void drawPixel(int16_t x, int16_t y, uint16_t colour) override {
    pixels_[y * width() + x] = colour;
  }
  uint16_t getPixel(int16_t x, int16_t y) const {
    return pixels_[y * width() + x];
  }
  uint16_t* getBuffer() const { return pixels_; }

 private:
  uint16_t* pixels_;
};
