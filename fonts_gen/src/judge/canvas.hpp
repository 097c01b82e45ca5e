// What the core draws, as pixels in memory.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "inkcell/strip.hpp"

namespace inkcell::gen {

/// Coverage of a rectangle of pixels, filled by the core.
class Canvas {
 public:
  explicit Canvas(const Rect& area)
      : area_(area),
        pixels_(static_cast<size_t>(area.x1 - area.x0) *
                static_cast<size_t>(area.y1 - area.y0)) {}

  const Rect& area() const { return area_; }

  uint8_t at(int x, int y) const { return *row(x, y); }

  /// The pixels of a row from (x, y) on.
  const uint8_t* row(int x, int y) const {
    return pixels_.data() + index(x, y);
  }

  Sink sink() {
    Sink sink;
    sink.window = area_;
    sink.context = this;
    sink.coverage = put_coverage;
    sink.solid = put_solid;
    return sink;
  }

 private:
  static void put_coverage(void* context,
                           int32_t x,
                           int32_t y,
                           const uint8_t* coverage,
                           int32_t count) {
    Canvas& canvas = *static_cast<Canvas*>(context);
    std::copy_n(coverage, count, canvas.pixels_.data() + canvas.index(x, y));
  }
  static void put_solid(void* context, int32_t x, int32_t y, int32_t count) {
    Canvas& canvas = *static_cast<Canvas*>(context);
    std::fill_n(canvas.pixels_.data() + canvas.index(x, y), count,
                uint8_t{255});
  }

  size_t index(int x, int y) const {
    return static_cast<size_t>(y - area_.y0) *
               static_cast<size_t>(area_.x1 - area_.x0) +
           static_cast<size_t>(x - area_.x0);
  }

  Rect area_;
  std::vector<uint8_t> pixels_;
};

}  // namespace inkcell::gen
