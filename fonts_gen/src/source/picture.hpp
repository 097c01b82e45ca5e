// The picture of a glyph at one size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "inkcell/geometry.hpp"

namespace inkcell::gen {

/// Pixels of 1, 2 or 4 bits, from the pixel of the glyph's origin, y down: the
/// last row of a letter on the baseline is -1.
struct Picture {
  int left = 0;
  int top = 0;
  int width = 0;
  int height = 0;
  std::vector<uint8_t> values;  // 0 to 2^bits - 1, row by row

  bool empty() const { return values.empty(); }
  Rect box() const { return {left, top, left + width, top + height}; }
  /// Whether the format has room for it: up to 255 x 255 pixels, of which the
  /// first is less than 128 px from the origin.
  bool is_in_format() const {
    const auto is_place = [](int px) { return px >= -128 && px < 128; };
    return width <= 255 && height <= 255 && is_place(left) && is_place(top);
  }
  uint8_t at(int x, int y) const {
    return values[static_cast<size_t>(y * width + x)];
  }
};

/// The picture of a rectangle whose pixels are value(x, y), without the empty
/// rows and columns around its ink.
template <typename Value>
Picture cropped(const Rect& area, const Value& value) {
  Rect ink = {area.x1, area.y1, area.x0, area.y0};
  for (int y = area.y0; y < area.y1; ++y) {
    for (int x = area.x0; x < area.x1; ++x) {
      if (value(x, y) != 0) {
        ink = {x < ink.x0 ? x : ink.x0, y < ink.y0 ? y : ink.y0,
               x >= ink.x1 ? x + 1 : ink.x1, y + 1};
      }
    }
  }
  if (ink.x0 >= ink.x1) {
    return {};
  }
  Picture picture = {ink.x0, ink.y0, ink.x1 - ink.x0, ink.y1 - ink.y0, {}};
  for (int y = ink.y0; y < ink.y1; ++y) {
    for (int x = ink.x0; x < ink.x1; ++x) {
      picture.values.push_back(static_cast<uint8_t>(value(x, y)));
    }
  }
  return picture;
}

}  // namespace inkcell::gen
