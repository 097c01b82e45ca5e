// Colours of the layers of a glyph.
#pragma once

#include <cstdint>
#include <tuple>

#include "shape/outline.hpp"

namespace inkcell::gen {

/// A colour with its opacity, or that of the text, whose channels are 0.
struct Paint {
  uint8_t red = 0;
  uint8_t green = 0;
  uint8_t blue = 0;
  uint8_t opacity = 255;
  bool is_ink = false;

  auto values() const { return std::tie(red, green, blue, opacity, is_ink); }
};

inline bool operator==(const Paint& a, const Paint& b) {
  return a.values() == b.values();
}
inline bool operator<(const Paint& a, const Paint& b) {
  return a.values() < b.values();
}

/// A part of a glyph in one colour. Painters draw one over the other.
struct PaintedOutline {
  Outline outline;  // [u]
  Paint paint;
};

}  // namespace inkcell::gen
