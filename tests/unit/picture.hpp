// A mock sink for small pictures, and expected pictures as text.
//
//   Picture<8, 4> picture;
//   draw(..., picture.sink());
//   CHECK_PICTURE(picture,
//                 "..##....\n"
//                 "..##....\n");
//
// The mock fails the running test when a pixel is drawn twice, lies outside the
// window, or a call breaks the contract of Sink.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "check.hpp"
#include "inkcell/strip.hpp"

/// Coverage as a character, in five steps.
constexpr char shade(uint8_t coverage) {
  if (coverage == 255) {
    return '#';
  }
  return coverage == 0 ? '.' : ":+*"[(coverage - 1) / 85];
}

template <int32_t kWidth, int32_t kHeight>
class Picture {
 public:
  /// The window's first pixel is at (x0, y0) of the screen.
  explicit Picture(int32_t x0 = 0, int32_t y0 = 0) : x0_(x0), y0_(y0) {}

  /// Valid as long as the picture stays where it is.
  inkcell::Sink sink() {
    return {{x0_, y0_, x0_ + kWidth, y0_ + kHeight}, this, coverage, solid};
  }

  /// Coverage of a pixel in screen coordinates.
  uint8_t at(int32_t x, int32_t y) const { return pixels_[y - y0_][x - x0_]; }

  int32_t calls() const { return calls_; }

  /// From here on pixels may be drawn again, over the old ones: the next glyph.
  void next_glyph() { clear(drawn_); }

  /// Whether `art`, lines of characters of shade(), shows this picture from its
  /// first row on; rows that art does not reach must be empty.
  bool matches(const char* art) const {
    for (int32_t y = 0; y < kHeight; ++y) {
      const bool given = *art != '\0';
      for (int32_t x = 0; x < kWidth; ++x) {
        if (shade(pixels_[y][x]) != (given ? *art++ : '.')) {
          return false;
        }
      }
      if (given && *art++ != '\n') {
        return false;
      }
    }
    return *art == '\0';
  }

  void print() const {
    for (int32_t y = 0; y < kHeight; ++y) {
      char line[kColumnCount + 1];
      for (int32_t x = 0; x < kWidth; ++x) {
        line[x] = shade(pixels_[y][x]);
      }
      line[kWidth] = '\n';
      check::write(line, sizeof(line));
    }
  }

 private:
  static constexpr auto kColumnCount = static_cast<size_t>(kWidth);
  static constexpr auto kRowCount = static_cast<size_t>(kHeight);
  using Rows = uint8_t[kRowCount][kColumnCount];

  static void clear(Rows& rows) {
    for (auto& row : rows) {
      for (uint8_t& pixel : row) {
        pixel = 0;
      }
    }
  }

  void put(int32_t x, int32_t y, uint8_t coverage) {
    const bool inside =
        x >= x0_ && x < x0_ + kWidth && y >= y0_ && y < y0_ + kHeight;
    CHECK(inside && "pixel inside the window");
    if (inside) {
      CHECK(drawn_[y - y0_][x - x0_] == 0 && "pixel drawn once");
      drawn_[y - y0_][x - x0_] = 1;
      uint8_t& pixel = pixels_[y - y0_][x - x0_];
      pixel = pixel > coverage ? pixel : coverage;
    }
  }

  static void coverage(void* context,
                       int32_t x,
                       int32_t y,
                       const uint8_t* coverage,
                       int32_t count) {
    CHECK(count >= 1 && count <= inkcell::kMaxSpan);
    auto& picture = *static_cast<Picture*>(context);
    ++picture.calls_;
    for (int32_t i = 0; i < count; ++i) {
      picture.put(x + i, y, coverage[i]);
    }
  }

  static void solid(void* context, int32_t x, int32_t y, int32_t count) {
    CHECK(count >= 1);
    auto& picture = *static_cast<Picture*>(context);
    ++picture.calls_;
    for (int32_t i = 0; i < count; ++i) {
      picture.put(x + i, y, 255);
    }
  }

  int32_t x0_;
  int32_t y0_;
  int32_t calls_ = 0;
  Rows pixels_ = {};
  Rows drawn_ = {};
};

/// `art`: rows of '.' 0, ':' 1..85, '+' 86..170, '*' 171..254 and '#' 255, each
/// closed by a line feed. Prints the picture if it differs.
#define CHECK_PICTURE(picture, art)                            \
  do {                                                         \
    if (!(picture).matches(art)) {                             \
      ::check::fail(__FILE__, __LINE__, #picture " differs:"); \
      (picture).print();                                       \
    }                                                          \
  } while (false)
