// Where dragged points come to rest: level with zones, guides and neighbours.
#pragma once

#include <utility>
#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// A movement, and the lines on which the dragged point then lies.
struct Snap {
  double dx = 0;  // [font units]
  double dy = 0;
  std::vector<std::pair<Point, Point>> lines;
};

/// Horizontal and vertical lines that a glyph is drawn to. [font units]
struct Zone {
  const char* label;
  double y = 0;
};
/// Baseline, x-height, cap height, ascender and descender, where the font says
/// them.
std::vector<Zone> zones_of(const Project& project);

/// A guide as a line of two of its points.
gen::Segment line_of(const Guideline& guide);

/// The movement next to (dx, dy) that takes the dragged point, which was at
/// `from`, level with something within `reach`. Points of `moving` go along and
/// attract nothing. `keeps_x` and `keeps_y` say which axis stays as it is.
Snap snap(const Editor& editor,
          const Selection& moving,
          Point from,
          Point move,
          double reach,
          bool keeps_x,
          bool keeps_y);

}  // namespace inkcell::design::editor
