// Snaps dragged points to zones, guides and neighbours.
#pragma once

#include <utility>
#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// A movement, and the lines that the dragged point snaps to.
struct Snap {
  double dx = 0;  // [font units]
  double dy = 0;
  std::vector<std::pair<Point, Point>> lines;
};

/// A horizontal or vertical line for drawing. [font units]
struct Zone {
  const char* label;
  double y = 0;
};
/// Baseline, x-height, cap height, ascender and descender, if the font states
/// them.
std::vector<Zone> zones_of(const Project& project);

/// A guide as a line through two of its points.
gen::Segment line_of(const Guideline& guide);

/// The movement nearest to (dx, dy) that puts the dragged point, which was at
/// `from`, level with something within `reach`. The selected points and knots
/// move along and attract nothing. `keeps_x` and `keeps_y` fix an axis.
Snap snap(const Editor& editor,
          Point from,
          Point move,
          double reach,
          bool keeps_x,
          bool keeps_y);

}  // namespace inkcell::design::editor
