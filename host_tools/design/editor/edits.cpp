#include "editor/edits.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "editor/parts.hpp"
#include "model/arguments.hpp"
#include "model/sources.hpp"
#include "shape/points.hpp"
#include "shape/shape.hpp"

namespace inkcell::design::editor {
namespace {

// A quarter of a circle as a cubic, 4/3 (sqrt(2) - 1).
constexpr double kKappa = 0.5522847498;

// The point before or after another one; none beyond the ends of an open
// contour.
std::optional<size_t> neighbour(const PointContour& contour,
                                size_t point,
                                bool is_after) {
  const size_t count = contour.points.size();
  if (contour.open() && point == (is_after ? count - 1 : 0)) {
    return std::nullopt;
  }
  return (point + (is_after ? 1 : count - 1)) % count;
}

// Whether an off-curve point belongs to a cubic.
bool is_cubic_handle(const PointContour& contour, size_t point) {
  if (contour.points[point].on_curve()) {
    return false;
  }
  size_t at = point;
  for (size_t i = 0; i < contour.points.size(); ++i) {
    at = (at + 1) % contour.points.size();
    if (contour.points[at].on_curve()) {
      return contour.points[at].type == PointType::curve;
    }
  }
  return false;
}

// The handles next to a point on the curve.
std::vector<size_t> handles_of(const PointContour& contour, size_t point) {
  std::vector<size_t> handles;
  for (const bool is_after : {false, true}) {
    const auto next = neighbour(contour, point, is_after);
    if (next && is_cubic_handle(contour, *next)) {
      handles.push_back(*next);
    }
  }
  return handles;
}

Selection with_handles(const Glyph& glyph, const Selection& selection) {
  Selection all = selection;
  for (const PointId id : selection) {
    const PointContour& contour = glyph.contours[id.contour];
    if (contour.points[id.point].on_curve()) {
      for (const size_t handle : handles_of(contour, id.point)) {
        all.insert({id.contour, handle});
      }
    }
  }
  return all;
}

Value set_point(PointId id, double x, double y) {
  return {{"do", "set_point"},
          {"contour", id.contour},
          {"point", id.point},
          {"x", std::round(x)},
          {"y", std::round(y)}};
}

// The far end of the quadratic with the control point `point`, seen from the
// other end; none if another control point is there, or it is a corner.
std::optional<size_t> smooth_end(const PointContour& contour,
                                 size_t point,
                                 bool is_after) {
  const auto end = neighbour(contour, point, is_after);
  return end && contour.points[*end].on_curve() && contour.points[*end].smooth
             ? end
             : std::nullopt;
}

// The place of a quadratic's control point whose one end moves from `from` to
// `to`: on the tangents at both ends, which keep their directions. Nothing if
// these do not meet between the ends.
std::optional<Point> slid_control(Point control,
                                  Point from,
                                  Point to,
                                  Point end) {
  constexpr double kLeastSine = 0.05;
  const Point a = gen::direction(control - from);
  const Point b = gen::direction(control - end);
  const double sine = gen::cross(a, b);
  if (std::abs(sine) < kLeastSine) {
    return std::nullopt;
  }
  const double along_a = gen::cross(end - to, b) / sine;
  const double along_b = gen::cross(end - to, a) / sine;
  return along_a > 0 && along_b > 0 ? std::optional<Point>(to + along_a * a)
                                    : std::nullopt;
}

// Moves the control points next to a moved point of quadratics: adds them to
// `moving`, or sets them in `commands`.
void follow_with_controls(const PointContour& contour,
                          PointId id,
                          Point move,
                          Selection& moving,
                          std::vector<Value>& commands) {
  const GlyphPoint& point = contour.points[id.point];
  for (const bool is_after : {false, true}) {
    const auto next = neighbour(contour, id.point, is_after);
    if (!next || contour.points[*next].on_curve() ||
        is_cubic_handle(contour, *next) ||
        moving.count({id.contour, *next}) != 0) {
      continue;
    }
    const auto end = smooth_end(contour, *next, is_after);
    const GlyphPoint& control = contour.points[*next];
    std::optional<Point> place;
    if (end && moving.count({id.contour, *end}) == 0) {
      place = slid_control({control.x, control.y}, {point.x, point.y},
                           Point{point.x, point.y} + move,
                           {contour.points[*end].x, contour.points[*end].y});
    }
    if (place) {
      commands.push_back(set_point({id.contour, *next}, place->x, place->y));
    } else {
      moving.insert({id.contour, *next});
    }
  }
}

// If the control point `id` of a quadratic moves: smooth points between it and
// other control points stay between them.
void follow_with_points(const PointContour& contour,
                        PointId id,
                        Point move,
                        std::vector<Value>& commands) {
  const GlyphPoint& control = contour.points[id.point];
  if (control.on_curve() || is_cubic_handle(contour, id.point)) {
    return;
  }
  for (const bool is_after : {false, true}) {
    const auto end = smooth_end(contour, id.point, is_after);
    const auto other =
        end ? neighbour(contour, *end, is_after) : std::optional<size_t>();
    if (!other || *other == id.point || contour.points[*other].on_curve() ||
        is_cubic_handle(contour, *other)) {
      continue;
    }
    const Point from = {control.x, control.y};
    const Point to = {contour.points[*other].x, contour.points[*other].y};
    const Point at = {contour.points[*end].x, contour.points[*end].y};
    const double size = gen::length(to - from);
    const double part = size == 0 ? 0 : gen::length(at - from) / size;
    const Point place = from + move + part * (to - from - move);
    commands.push_back(set_point({id.contour, *end}, place.x, place.y));
  }
}

// Turns the handle `id` opposite to a handle at `other`; its length is kept.
Value turn_handle(const PointContour& contour,
                  PointId id,
                  const GlyphPoint& centre,
                  Point other) {
  const GlyphPoint& handle = contour.points[id.point];
  const double length = std::hypot(handle.x - centre.x, handle.y - centre.y);
  const double dx = centre.x - other.x;
  const double dy = centre.y - other.y;
  const double size = std::hypot(dx, dy);
  if (size == 0) {
    return nullptr;
  }
  return set_point(id, centre.x + length * dx / size,
                   centre.y + length * dy / size);
}

// If the handle `id` belongs to a smooth point: turns the opposite handle with
// it.
Value turn_opposite(const Glyph& glyph, PointId id, double dx, double dy) {
  const PointContour& contour = glyph.contours[id.contour];
  if (!is_cubic_handle(contour, id.point)) {
    return nullptr;
  }
  for (const bool is_after : {false, true}) {
    const auto centre = neighbour(contour, id.point, is_after);
    if (!centre || !contour.points[*centre].smooth) {
      continue;
    }
    const auto other = neighbour(contour, *centre, is_after);
    if (other && is_cubic_handle(contour, *other)) {
      const GlyphPoint& moved = contour.points[id.point];
      return turn_handle(contour, {id.contour, *other}, contour.points[*centre],
                         {moved.x + dx, moved.y + dy});
    }
  }
  return nullptr;
}

size_t on_curve_count(const PointContour& contour) {
  return static_cast<size_t>(
      std::count_if(contour.points.begin(), contour.points.end(),
                    [](const GlyphPoint& p) { return p.on_curve(); }));
}

// Off-curve neighbours first: each step leaves a valid contour.
void delete_point(size_t contour_index,
                  PointContour& contour,
                  size_t point,
                  std::vector<Value>& commands) {
  std::vector<size_t> gone = {point};
  if (contour.points[point].on_curve()) {
    const std::vector<size_t> handles = handles_of(contour, point);
    if (handles.size() == 2) {
      gone.insert(gone.begin(), handles.begin(), handles.end());
    }
  }
  for (size_t i = 0; i < gone.size(); ++i) {
    commands.push_back({{"do", "delete_point"},
                        {"contour", contour_index},
                        {"point", gone[i]}});
    contour.points.erase(contour.points.begin() +
                         static_cast<std::ptrdiff_t>(gone[i]));
    for (size_t k = i + 1; k < gone.size(); ++k) {
      gone[k] -= gone[k] > gone[i] ? size_t{1} : size_t{0};
    }
  }
}

}  // namespace

Value batch(std::vector<Value> commands) {
  if (commands.size() == 1) {
    return commands.front();
  }
  return {{"do", "batch"}, {"commands", std::move(commands)}};
}

std::vector<Value> without_source(const Glyph& glyph) {
  std::vector<Value> commands;
  for (const char* key : {kStrokesKey, kOwnContoursKey, kTreeKey}) {
    if (glyph.lib.contains(key)) {
      commands.push_back({{"do", "set_glyph_lib"}, {"key", key}});
    }
  }
  return commands;
}

Value move_selection(const Glyph& glyph,
                     const Selection& selection,
                     double dx,
                     double dy) {
  Selection moving = with_handles(glyph, selection);
  if (moving.empty()) {
    return nullptr;
  }
  std::vector<Value> commands;
  for (const PointId id : selection) {
    const PointContour& contour = glyph.contours[id.contour];
    if (contour.points[id.point].on_curve()) {
      follow_with_controls(contour, id, {dx, dy}, moving, commands);
    } else if (selection.size() == 1) {
      follow_with_points(contour, id, {dx, dy}, commands);
    }
  }
  Value points = Value::array();
  for (const PointId id : moving) {
    points.push_back({id.contour, id.point});
  }
  commands.push_back(
      {{"do", "move_points"}, {"points", points}, {"dx", dx}, {"dy", dy}});
  if (moving.size() == 1) {
    Value turn = turn_opposite(glyph, *moving.begin(), dx, dy);
    if (!turn.is_null()) {
      commands.push_back(std::move(turn));
    }
  }
  return batch(std::move(commands));
}

Value delete_points(const Glyph& glyph, const Selection& selection) {
  std::vector<Value> commands;
  for (size_t c = glyph.contours.size(); c-- > 0;) {
    std::vector<size_t> points;
    size_t on_curve = 0;
    for (const PointId id : selection) {
      if (id.contour == c) {
        points.push_back(id.point);
        on_curve += glyph.contours[c].points[id.point].on_curve() ? 1u : 0u;
      }
    }
    if (points.empty()) {
      continue;
    }
    if (on_curve_count(glyph.contours[c]) < on_curve + 2) {
      commands.push_back({{"do", "delete_contour"}, {"contour", c}});
      continue;
    }
    // Handles move with their points, then handles that are selected alone.
    PointContour contour = glyph.contours[c];
    std::stable_sort(points.begin(), points.end(), [&](size_t a, size_t b) {
      return contour.points[a].on_curve() > contour.points[b].on_curve();
    });
    for (size_t i = 0; i < points.size(); ++i) {
      const GlyphPoint gone = glyph.contours[c].points[points[i]];
      const auto found =
          std::find(contour.points.begin(), contour.points.end(), gone);
      if (found != contour.points.end()) {
        delete_point(c, contour,
                     static_cast<size_t>(found - contour.points.begin()),
                     commands);
      }
    }
  }
  return commands.empty() ? Value() : batch(std::move(commands));
}

Value align_points(const Glyph& glyph, const Selection& selection) {
  Selection points;
  for (const PointId id : selection) {
    if (glyph.contours[id.contour].points[id.point].on_curve()) {
      points.insert(id);
    }
  }
  if (points.size() < 2) {
    return nullptr;
  }
  Point low = {INFINITY, INFINITY};
  Point high = {-INFINITY, -INFINITY};
  Point sum;
  for (const PointId id : points) {
    const GlyphPoint& p = glyph.contours[id.contour].points[id.point];
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    sum = {sum.x + p.x, sum.y + p.y};
  }
  const bool is_upright = high.x - low.x < high.y - low.y;
  const auto count = static_cast<double>(points.size());
  const double mean = std::round((is_upright ? sum.x : sum.y) / count);
  std::vector<Value> commands;
  for (const PointId id : points) {
    const GlyphPoint& p = glyph.contours[id.contour].points[id.point];
    const double dx = is_upright ? mean - p.x : 0;
    const double dy = is_upright ? 0 : mean - p.y;
    if (dx != 0 || dy != 0) {
      commands.push_back(move_selection(glyph, {id}, dx, dy));
    }
  }
  return commands.empty() ? Value() : batch(std::move(commands));
}

Value transform_selection(const Editor& editor, const Value& matrix) {
  const Project& project = editor.project();
  const GlyphPointer glyph = editor.stored();
  Value command = {{"do", "transform"}, {"matrix", matrix}};
  if (editor.component || editor.part) {
    Glyph alone;
    if (editor.part) {
      alone.contours =
          contours_of_part(project, parts_of(*glyph)[*editor.part]);
    } else {
      alone.components = {glyph->components[*editor.component]};
    }
    const gen::Shape shape(outline_of(project, alone));
    const double scale = project.units_per_em() / gen::kUPerEm;
    const double x = std::round(scale * (shape.box().x0 + shape.box().x1) / 2);
    const double y = std::round(scale * (shape.box().y0 + shape.box().y1) / 2);
    Matrix to;
    to.dx = -x;
    to.dy = -y;
    to = product(Arguments(command).matrix("matrix"), to);
    to.dx += x;
    to.dy += y;
    if (editor.part) {
      return map_part(*glyph, *editor.part, to);
    }
    to = product(to, glyph->components[*editor.component].matrix);
    return {{"do", "set_component"},
            {"component", *editor.component},
            {"matrix", {to.xx, to.xy, to.yx, to.yy, to.dx, to.dy}}};
  }
  command["about"] = "middle";
  if (!editor.selection.empty()) {
    Value points = Value::array();
    for (const PointId id : with_handles(*glyph, editor.selection)) {
      points.push_back({id.contour, id.point});
    }
    command["points"] = points;
  }
  return command;
}

Value selected_contours(const Editor& editor) {
  Value contours = Value::array();
  for (size_t c = 0; c < editor.glyph()->contours.size(); ++c) {
    const auto first = editor.selection.lower_bound({c, 0});
    if (first != editor.selection.end() && first->contour == c) {
      contours.push_back(c);
    }
  }
  return contours;
}

Value curve_line(const Glyph& glyph, PointId id) {
  const PointContour& contour = glyph.contours[id.contour];
  const GlyphPoint& to = contour.points[id.point];
  const auto before = neighbour(contour, id.point, false);
  if (to.type != PointType::line || !before) {
    return nullptr;
  }
  const GlyphPoint& from = contour.points[*before];
  const auto handle = [&](double part) -> Value {
    return {std::round(from.x + part * (to.x - from.x)),
            std::round(from.y + part * (to.y - from.y)), "offcurve"};
  };
  // Handles of the first point are at the end.
  const size_t at = id.point == 0 ? contour.points.size() : id.point;
  return batch({{{"do", "set_point"},
                 {"contour", id.contour},
                 {"point", id.point},
                 {"type", "curve"}},
                {{"do", "insert_points"},
                 {"contour", id.contour},
                 {"at", at},
                 {"points", {handle(1.0 / 3), handle(2.0 / 3)}}}});
}

Value toggle_smooth(const Glyph& glyph, PointId id) {
  const PointContour& contour = glyph.contours[id.contour];
  const GlyphPoint& point = contour.points[id.point];
  if (!point.on_curve()) {
    return nullptr;
  }
  std::vector<Value> commands = {{{"do", "set_point"},
                                  {"contour", id.contour},
                                  {"point", id.point},
                                  {"smooth", !point.smooth}}};
  const std::vector<size_t> handles = handles_of(contour, id.point);
  if (!point.smooth && handles.size() == 2) {
    const GlyphPoint& kept = contour.points[handles[0]];
    Value turn =
        turn_handle(contour, {id.contour, handles[1]}, point, {kept.x, kept.y});
    if (!turn.is_null()) {
      commands.push_back(std::move(turn));
    }
  }
  return batch(std::move(commands));
}

Value replace_contours(const Glyph& glyph,
                       const std::vector<PointContour>& contours,
                       const char* title) {
  std::vector<Value> commands;
  for (size_t i = glyph.contours.size(); i-- > 0;) {
    if (std::find(contours.begin(), contours.end(), glyph.contours[i]) ==
        contours.end()) {
      commands.push_back({{"do", "delete_contour"}, {"contour", i}});
    }
  }
  for (const PointContour& contour : contours) {
    if (std::find(glyph.contours.begin(), glyph.contours.end(), contour) ==
        glyph.contours.end()) {
      commands.push_back(add_contour(contour));
    }
  }
  if (commands.empty()) {
    return nullptr;
  }
  return {{"do", "batch"}, {"title", title}, {"commands", std::move(commands)}};
}

Value add_contour(const PointContour& contour) {
  return {{"do", "add_contour"}, {"points", contour_value(contour)}};
}

Value draw_contour(const Editor& editor, const PointContour& contour) {
  const Project& project = editor.project();
  return add_contour(
      in_direction_of(project, *editor.stored(), {contour}).front());
}

PointContour rectangle(Point a, Point b) {
  const double x0 = std::min(a.x, b.x);
  const double x1 = std::max(a.x, b.x);
  const double y0 = std::min(a.y, b.y);
  const double y1 = std::max(a.y, b.y);
  PointContour contour;
  for (const Point p : {Point{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}) {
    GlyphPoint point;
    point.x = p.x;
    point.y = p.y;
    contour.points.push_back(point);
  }
  return contour;
}

PointContour ellipse(Point a, Point b) {
  const Point centre = {(a.x + b.x) / 2, (a.y + b.y) / 2};
  const double rx = std::abs(a.x - b.x) / 2;
  const double ry = std::abs(a.y - b.y) / 2;
  PointContour contour;
  const auto add = [&](double x, double y, PointType type) {
    GlyphPoint point;
    point.x = std::round(centre.x + rx * x);
    point.y = std::round(centre.y + ry * y);
    point.type = type;
    point.smooth = type == PointType::curve;
    contour.points.push_back(point);
  };
  Point at = {1, 0};
  for (int i = 0; i < 4; ++i) {
    const Point next = {-at.y, at.x};
    add(at.x, at.y, PointType::curve);
    add(at.x + kKappa * next.x, at.y + kKappa * next.y, PointType::offcurve);
    add(next.x + kKappa * at.x, next.y + kKappa * at.y, PointType::offcurve);
    at = next;
  }
  return contour;
}

}  // namespace inkcell::design::editor
