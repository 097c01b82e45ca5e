// The picture of a glyph at one size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

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
  uint8_t at(int x, int y) const {
    return values[static_cast<size_t>(y) * static_cast<size_t>(width) +
                  static_cast<size_t>(x)];
  }
};

/// The picture of a rectangle whose pixels are value(x, y), without the empty
/// rows and columns around its ink.
template <typename Value>
Picture cropped(int x0, int y0, int x1, int y1, const Value& value) {
  int left = x1, right = x0, top = y1, bottom = y0;
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      if (value(x, y) != 0) {
        left = x < left ? x : left;
        right = x >= right ? x + 1 : right;
        top = y < top ? y : top;
        bottom = y + 1;
      }
    }
  }
  if (left >= right) {
    return {};
  }
  Picture picture = {left, top, right - left, bottom - top, {}};
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      picture.values.push_back(static_cast<uint8_t>(value(x, y)));
    }
  }
  return picture;
}

}  // namespace inkcell::gen
