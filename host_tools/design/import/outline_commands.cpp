#include "import/outline_commands.hpp"

#include <algorithm>
#include <cmath>

#include "model/contours.hpp"

namespace inkcell::design {

std::vector<Value> commands_for_outline(const Project& project,
                                        const std::string& glyph,
                                        const gen::Outline& outline) {
  std::vector<Value> commands;
  Value contours = Value::array();
  double left = HUGE_VAL;
  double right = -HUGE_VAL;
  for (const PointContour& contour : contours_of(project, outline)) {
    for (const GlyphPoint& point : contour.points) {
      if (point.on_curve()) {
        left = std::min(left, point.x);
        right = std::max(right, point.x);
      }
    }
    contours.push_back(contour_value(contour));
  }
  if (project.find(glyph) == nullptr) {
    const double width =
        contours.empty() ? 0 : std::round(right + std::max(left, 0.0));
    commands.push_back({{"do", "add_glyph"},
                        {"glyph", glyph},
                        {"width", std::max(width, 0.0)}});
  }
  commands.push_back(
      {{"do", "set_contours"}, {"glyph", glyph}, {"contours", contours}});
  return commands;
}

}  // namespace inkcell::design
