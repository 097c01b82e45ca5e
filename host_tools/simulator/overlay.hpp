// Marks over text: cells of its glyphs, or the points of their outlines.
#pragma once

#include <vector>

#include "canvas.hpp"
#include "outline_points.hpp"

namespace inkcell::tools {

/// A place on the display. [px, y down]
struct Place {
  float x = 0;
  float y = 0;
};

struct Overlay {
  struct Curve {
    std::vector<Place> places;
    bool is_control = false;  // a line between points
  };
  struct Dot {
    Place at;
    PointKind kind = PointKind::corner;
  };
  struct Leaf {
    Place corners[4];
    bool is_saturated = false;
  };

  std::vector<Curve> curves;
  std::vector<Dot> dots;
  std::vector<Leaf> leaves;
};

/// The overlay of lines, with their origins. Outlines are shown without grid
/// fitting.
Overlay make_overlay(const Font& font,
                     const std::vector<Line>& lines,
                     const std::vector<Point>& origins,
                     const Style& style);

}  // namespace inkcell::tools
