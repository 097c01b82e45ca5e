#include "editor/strokes.hpp"

#include <algorithm>
#include <cmath>

#include "editor/edits.hpp"
#include "model/sources.hpp"
#include "shape/points.hpp"

namespace inkcell::design::editor {
namespace {

// The fit of paths that are not smooth_path(), as in set_strokes. [u]
constexpr double kPathFit_u = 0.5;

constexpr double kLeastNib = 1;  // [font units]
constexpr double kAngleStep = 15;

Value with_strokes(Value strokes) {
  return {{"do", "set_strokes"}, {"strokes", std::move(strokes)}};
}

Value strokes_value(const Glyph& glyph) {
  return glyph.lib[kStrokesKey];
}

double degrees(double radians) {
  return std::round(radians / gen::kDegree * 10) / 10;
}

// Writes the nib of a point, which may be shorter.
void write_nib(const Nib& nib, Value& point) {
  while (point.size() < 5) {
    point.push_back(nullptr);
  }
  point[2] = std::round(nib.width);
  point[3] = std::round(nib.height);
  point[4] = degrees(nib.angle);
}

}  // namespace

bool has_strokes(const Glyph& glyph) {
  return glyph.lib.contains(kStrokesKey);
}

std::vector<Stroke> strokes_of(const Glyph& glyph) {
  std::vector<Stroke> strokes;
  if (has_strokes(glyph)) {
    for (const Value& value : glyph.lib[kStrokesKey]) {
      strokes.push_back(parse_stroke(value, 1));
    }
  }
  return strokes;
}

std::vector<gen::Segment> centre_line(const Project& project,
                                      const Stroke& stroke) {
  return fit_path(stroke, kPathFit_u * project.units_per_em() / gen::kUPerEm)
      .pieces;
}

NibHandles handles_of(const StrokePoint& knot, const Nib& nib) {
  const Point along = {std::cos(nib.angle), std::sin(nib.angle)};
  const Point across = {-along.y, along.x};
  return {knot.at + nib.width / 2 * along, knot.at + nib.height / 2 * across};
}

Nib with_handle(const StrokePoint& knot,
                const Nib& nib,
                bool is_along,
                Point to,
                bool steps) {
  Nib result = nib;
  const Point arm = to - knot.at;
  if (!is_along) {
    const Point across = {-std::sin(nib.angle), std::cos(nib.angle)};
    result.height =
        std::max(kLeastNib, std::round(2 * std::fabs(dot(arm, across))));
    return result;
  }
  if (length(arm) == 0) {
    return result;
  }
  result.width = std::max(kLeastNib, std::round(2 * length(arm)));
  const double step = steps ? kAngleStep : 1;
  const double angle =
      step * std::round(std::atan2(arm.y, arm.x) / gen::kDegree / step);
  // A nib that is turned by 180 degrees is the same: no turn on the way.
  const double old = nib.angle / gen::kDegree;
  result.angle =
      gen::kDegree * (angle + 180 * std::floor((old - angle) / 180 + 0.5));
  return result;
}

Value move_knots(const Glyph& glyph,
                 const Selection& knots,
                 double dx,
                 double dy) {
  if (knots.empty()) {
    return nullptr;
  }
  Value strokes = strokes_value(glyph);
  for (const PointId id : knots) {
    Value& point = strokes[id.contour]["points"][id.point];
    point[0] = point[0].get<double>() + dx;
    point[1] = point[1].get<double>() + dy;
  }
  return with_strokes(std::move(strokes));
}

Value both(Value a, Value b) {
  if (a.is_null() || b.is_null()) {
    return a.is_null() ? b : a;
  }
  return batch({std::move(a), std::move(b)});
}

Value move_selected(const Editor& editor, Point by) {
  const Glyph& glyph = *editor.stored();
  return both(move_knots(glyph, editor.knots, by.x, by.y),
              move_selection(glyph, editor.selection, by.x, by.y));
}

Value set_nib(const Glyph& glyph, PointId knot, const Nib& nib) {
  Value strokes = strokes_value(glyph);
  const std::vector<Nib> nibs = nibs_of(parse_stroke(strokes[knot.contour], 1));
  Value& points = strokes[knot.contour]["points"];
  for (size_t i = 0; i < nibs.size(); ++i) {
    write_nib(i == knot.point ? nib : nibs[i], points[i]);
  }
  return with_strokes(std::move(strokes));
}

Value delete_knots(const Glyph& glyph, const Selection& knots) {
  if (knots.empty()) {
    return nullptr;
  }
  Value strokes = strokes_value(glyph);
  for (auto id = knots.rbegin(); id != knots.rend(); ++id) {
    Value& points = strokes[id->contour]["points"];
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(id->point));
    if (points.empty()) {
      strokes.erase(strokes.begin() + static_cast<std::ptrdiff_t>(id->contour));
    }
  }
  return with_strokes(std::move(strokes));
}

Value toggle_corner(const Glyph& glyph, PointId knot) {
  Value strokes = strokes_value(glyph);
  Value& point = strokes[knot.contour]["points"][knot.point];
  if (point.size() > 5) {
    point.erase(point.begin() + 5);
  } else {
    while (point.size() < 5) {
      point.push_back(nullptr);
    }
    point.push_back("corner");
  }
  return with_strokes(std::move(strokes));
}

Value add_knot(const Glyph& glyph, PointId before, Point at) {
  Value strokes = strokes_value(glyph);
  Value& points = strokes[before.contour]["points"];
  const Value knot = {std::round(at.x), std::round(at.y)};
  points.insert(points.begin() + static_cast<std::ptrdiff_t>(before.point) + 1,
                knot);
  return with_strokes(std::move(strokes));
}

}  // namespace inkcell::design::editor
