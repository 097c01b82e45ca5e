// The command that makes the curves of a glyph anew, from its field.
#include <algorithm>
#include <cmath>
#include <utility>

#include "model/command_table.hpp"
#include "model/contours.hpp"
#include "trace/field_outline.hpp"

namespace inkcell::design {
namespace {

// The field is this true at 8 to 64 px/em, as in `roundtrip`. [1/255]
constexpr int kTolerance = 4;

// Contours in the order of those before, each from the place where one of them
// began: where points are as many as in another master, they correspond to it.
void keep_starts(const std::vector<PointContour>& before,
                 std::vector<PointContour>& contours) {
  std::vector<std::pair<size_t, PointContour>> placed;
  for (PointContour& contour : contours) {
    double least = INFINITY;
    size_t begins = 0;
    size_t place = before.size();
    for (size_t i = 0; i < contour.points.size(); ++i) {
      const GlyphPoint& point = contour.points[i];
      for (size_t k = 0; k < before.size(); ++k) {
        if (!point.on_curve() || before[k].points.empty()) {
          continue;
        }
        const GlyphPoint& start = before[k].points.front();
        const double away = std::hypot(point.x - start.x, point.y - start.y);
        if (away < least) {
          least = away;
          begins = i;
          place = k;
        }
      }
    }
    std::rotate(contour.points.begin(),
                contour.points.begin() + static_cast<std::ptrdiff_t>(begins),
                contour.points.end());
    placed.emplace_back(place, std::move(contour));
  }
  std::stable_sort(
      placed.begin(), placed.end(),
      [](const auto& a, const auto& b) { return a.first < b.first; });
  for (size_t i = 0; i < placed.size(); ++i) {
    contours[i] = std::move(placed[i].second);
  }
}

Change curves_of_field(const Project& project, const Arguments& arguments) {
  FieldOutlineOptions options;
  options.tolerance_u = arguments.number("fit", options.tolerance_u);
  if (!(options.tolerance_u >= 0.05 && options.tolerance_u <= 16)) {
    arguments.refuse("\"fit\" is 0.05 to 16, in 1/1024 em");
  }
  return edited(project, arguments, [&](Glyph& glyph) {
    Glyph own = glyph;
    own.components.clear();
    const gen::Shape shape(outline_of(project, own));
    if (shape.empty()) {
      arguments.refuse("the glyph has no closed contours of its own");
    }
    gen::Target target;
    target.coding = gen::Coding::field;
    target.tolerance = kTolerance;
    const ShapeField field(shape, target);
    std::vector<PointContour> contours = in_direction_of(
        project, glyph,
        contours_of(project, outline_of(field.field(), options),
                    arguments.number("grid", 1)));
    keep_starts(glyph.contours, contours);
    glyph.contours = std::move(contours);
  });
}

}  // namespace

void add_field_commands(CommandTable& table) {
  table["curves_of_field"] = curves_of_field;
}

}  // namespace inkcell::design
