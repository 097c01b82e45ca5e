#include "import/outline_commands.hpp"

#include <algorithm>
#include <cmath>

#include "model/contours.hpp"

namespace inkcell::design {
namespace {

// The advance with equal bearings on both sides.
double advance_of(const std::vector<PointContour>& contours) {
  double left = HUGE_VAL;
  double right = -HUGE_VAL;
  for (const PointContour& contour : contours) {
    for (const GlyphPoint& point : contour.points) {
      if (point.on_curve()) {
        left = std::min(left, point.x);
        right = std::max(right, point.x);
      }
    }
  }
  return contours.empty()
             ? 0
             : std::max(std::round(right + std::max(left, 0.0)), 0.0);
}

}  // namespace

std::vector<Value> commands_for_outline(const Project& project,
                                        const std::string& glyph,
                                        const gen::Outline& outline,
                                        const OutlineUse& use) {
  std::vector<Value> commands;
  const GlyphPointer before = project.find(glyph);
  const Glyph shown = before == nullptr ? Glyph() : *before;
  const std::vector<PointContour> added =
      in_direction_of(project, shown, contours_of(project, outline, use.grid));
  if (before == nullptr) {
    commands.push_back(
        {{"do", "add_glyph"}, {"glyph", glyph}, {"width", advance_of(added)}});
    if (use.unicode) {
      commands.back()["unicodes"] = {static_cast<uint32_t>(*use.unicode)};
    }
  }
  Value contours = Value::array();
  for (const PointContour& contour : shown.contours) {
    if (!use.replaces) {
      contours.push_back(contour_value(contour));
    }
  }
  for (const PointContour& contour : added) {
    contours.push_back(contour_value(contour));
  }
  commands.push_back(
      {{"do", "set_contours"}, {"glyph", glyph}, {"contours", contours}});
  return commands;
}

}  // namespace inkcell::design
