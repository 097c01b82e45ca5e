// What the outlines of a font are read with: see outline_coding() in font.hpp.
#pragma once

#include <stdint.h>

namespace inkcell {
namespace detail {

// What all outlines of a font share: sections CODE and GLYF.
struct OutlineCoding {
  const uint8_t* table = nullptr;  // 2^code_bits words, at an even address
  uint8_t code_bits = 1;
  int8_t grid_shift = 0;    // grid units are 2^grid_shift font units
  uint16_t max_points = 0;  // of a glyph; no reader goes on beyond
};

}  // namespace detail
}  // namespace inkcell
