#include "shape/pixel_regions.hpp"

#include <cstddef>

namespace inkcell::gen {

std::vector<int> pixel_regions(std::vector<uint8_t> mask,
                               int width,
                               bool by_corners) {
  const int steps[] = {1,         -1,        width,     -width,
                       width + 1, width - 1, 1 - width, -1 - width};
  const int joined = by_corners ? 8 : 4;
  std::vector<int> sizes;
  std::vector<int> left;
  for (size_t first = 0; first < mask.size(); ++first) {
    if (mask[first] == 0) {
      continue;
    }
    int size = 0;
    mask[first] = 0;
    for (left = {static_cast<int>(first)}; !left.empty(); ++size) {
      const int at = left.back();
      left.pop_back();
      for (int k = 0; k < joined; ++k) {
        uint8_t& next = mask[static_cast<size_t>(at + steps[k])];
        if (next != 0) {
          next = 0;
          left.push_back(at + steps[k]);
        }
      }
    }
    sizes.push_back(size);
  }
  return sizes;
}

}  // namespace inkcell::gen
