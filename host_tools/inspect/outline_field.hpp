// The field of an outline glyph near its edge, as the device makes it.
#pragma once

#include <cstdint>
#include <vector>

#include "colours.hpp"
#include "inkcell/font.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::tools {

/// Distances at all whole u of a box, [x0, x1) x [y0, y1), y up. The glyph is
/// drawn at 32 px/em in 1024 sub-pixel positions; its pixels are distances,
/// because the filter is a ramp of +-4 px, 128 u, the widest that there is.
class OutlineField {
 public:
  OutlineField(const Font& font, uint16_t glyph, const Rect& box_u);

  /// Between whole u by bi-linear interpolation.
  FieldSample at(double x_u, double y_u) const;

 private:
  double distance(int x, int y) const;

  Rect box_;
  std::vector<float> distances_u_;
};

}  // namespace inkcell::tools
