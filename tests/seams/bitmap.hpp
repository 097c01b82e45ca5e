// A square picture, and the pieces of ink in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

struct Bitmap {
  int side;
  std::vector<uint8_t> pixels;

  explicit Bitmap(int columns)
      : side(columns), pixels(static_cast<size_t>(columns * columns)) {}
  uint8_t& at(int x, int y) {
    return pixels[static_cast<size_t>(y * side + x)];
  }

  // Takes a piece away that has ink at (x, y): what touches it, also at
  // corners. Calls visit(x, y) for each pixel of it.
  template <typename Visit>
  void take_piece(int x, int y, const Visit& visit) {
    std::vector<int> open = {y * side + x};
    at(x, y) = 0;
    while (!open.empty()) {
      const int at_x = open.back() % side;
      const int at_y = open.back() / side;
      open.pop_back();
      visit(at_x, at_y);
      for (int i = 0; i < 9; ++i) {
        const int to_x = at_x + i % 3 - 1;
        const int to_y = at_y + i / 3 - 1;
        if (to_x >= 0 && to_x < side && to_y >= 0 && to_y < side &&
            at(to_x, to_y) != 0) {
          at(to_x, to_y) = 0;
          open.push_back(to_y * side + to_x);
        }
      }
    }
  }
};
