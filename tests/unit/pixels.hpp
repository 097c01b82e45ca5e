// The pixels of a rectangle, and what tests ask of rectangles.
//
//   for (const auto [x, y] : pixels_of(8, 4)) {
//     CHECK_EQ(picture.at(x, y), 0);
//   }
#pragma once

#include <stdint.h>

#include "check.hpp"
#include "inkcell/geometry.hpp"

struct Pixel {
  int32_t x;
  int32_t y;
};

/// Row by row. Ends at the end of a row after a check has failed.
class Pixels {
 public:
  explicit Pixels(const inkcell::Rect& rect) : rect_(rect) {}

  class Iterator {
   public:
    Iterator(const inkcell::Rect& rect, int32_t y)
        : rect_(rect), at_({rect.x0, y}) {}

    Pixel operator*() const { return at_; }
    bool operator!=(const Iterator& other) const { return at_.y < other.at_.y; }
    Iterator& operator++() {
      if (++at_.x == rect_.x1) {
        at_ = {rect_.x0, check::failed() ? rect_.y1 : at_.y + 1};
      }
      return *this;
    }

   private:
    inkcell::Rect rect_;
    Pixel at_;
  };

  Iterator begin() const {
    return {rect_, is_empty(rect_) ? rect_.y1 : rect_.y0};
  }
  Iterator end() const { return {rect_, rect_.y1}; }

 private:
  inkcell::Rect rect_;
};

inline Pixels pixels_of(const inkcell::Rect& rect) {
  return Pixels(rect);
}
inline Pixels pixels_of(int32_t width, int32_t height) {
  return Pixels({0, 0, width, height});
}

inline bool holds(const inkcell::Rect& rect, int32_t x, int32_t y) {
  return x >= rect.x0 && x < rect.x1 && y >= rect.y0 && y < rect.y1;
}

inline bool is_same(const inkcell::Rect& a, const inkcell::Rect& b) {
  return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1;
}
