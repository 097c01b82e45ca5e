// Pixels of one colour that touch.
#pragma once

#include <cstdint>
#include <vector>

namespace inkcell::gen {

/// The sizes of all regions of marked pixels, the first one met first; joined
/// by corners, too, or by edges alone. `mask` holds rows of `width`: 1 where a
/// pixel is marked, 0 in its outermost rows and columns; it is used up. [px]
std::vector<int> pixel_regions(std::vector<uint8_t> mask,
                               int width,
                               bool by_corners);

}  // namespace inkcell::gen
