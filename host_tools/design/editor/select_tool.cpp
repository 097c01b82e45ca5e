// Selects and drags points, edges and components.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/edits.hpp"
#include "editor/knot_drag.hpp"
#include "editor/parts.hpp"
#include "editor/segments.hpp"
#include "editor/snapping.hpp"
#include "editor/strokes.hpp"
#include "editor/tool.hpp"
#include "model/sources.hpp"

namespace inkcell::design::editor {
namespace {

// The part of the pointer's reach within which points snap.
constexpr double kSnapPart = 0.6;

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// On-curve points have priority over handles.
std::optional<PointId> point_near(const Glyph& glyph, const Pointer& pointer) {
  std::optional<PointId> best;
  double nearest = pointer.reach;
  for (const bool on_curve : {true, false}) {
    for (size_t c = 0; c < glyph.contours.size() && !best; ++c) {
      const std::vector<GlyphPoint>& points = glyph.contours[c].points;
      for (size_t p = 0; p < points.size(); ++p) {
        const double d = distance(pointer.at, {points[p].x, points[p].y});
        if (points[p].on_curve() == on_curve && d < nearest) {
          nearest = d;
          best = PointId{c, p};
        }
      }
    }
  }
  return best;
}

// The end point of a line.
std::optional<PointId> end_of_line(const Glyph& glyph, const OnCurve& place) {
  const PointContour& contour = glyph.contours[place.contour];
  const gen::Segment segment = segments_of(contour)[place.segment];
  const size_t count = contour.points.size();
  for (size_t p = 0; p < count; ++p) {
    const GlyphPoint& to = contour.points[p];
    const GlyphPoint& from = contour.points[(p + count - 1) % count];
    if (to.type == PointType::line && to.x == segment.p[1].x &&
        to.y == segment.p[1].y && from.x == segment.p[0].x &&
        from.y == segment.p[0].y) {
      return PointId{place.contour, p};
    }
  }
  return std::nullopt;
}

// The points at the ends, and the handles, of a segment.
Selection points_of(const Glyph& glyph, const OnCurve& place) {
  const PointContour& contour = glyph.contours[place.contour];
  const gen::Segment segment = segments_of(contour)[place.segment];
  const size_t count = segment.kind == gen::Segment::Kind::line        ? 2
                       : segment.kind == gen::Segment::Kind::quadratic ? 3
                                                                       : 4;
  Selection points;
  for (size_t p = 0; p < contour.points.size(); ++p) {
    for (size_t i = 0; i < count; ++i) {
      if (contour.points[p].x == segment.p[i].x &&
          contour.points[p].y == segment.p[i].y) {
        points.insert({place.contour, p});
      }
    }
  }
  return points;
}

std::optional<size_t> component_at(const Editor& editor, Point at) {
  const GlyphPointer glyph = editor.glyph();
  for (size_t i = glyph->components.size(); i-- > 0;) {
    Glyph part;
    append_component(editor.shown_project(), 0, glyph->components[i],
                     part.contours);
    if (is_inside(part.contours, at)) {
      return i;
    }
  }
  return std::nullopt;
}

std::optional<size_t> guide_near(const Glyph& glyph, const Pointer& pointer) {
  for (size_t i = 0; i < glyph.guidelines.size(); ++i) {
    const gen::Segment line = line_of(glyph.guidelines[i]);
    const double dx = line.p[1].x - line.p[0].x;
    const double dy = line.p[1].y - line.p[0].y;
    if (std::abs(dx * (pointer.at.y - line.p[0].y) -
                 dy * (pointer.at.x - line.p[0].x)) <
        pointer.reach * std::hypot(dx, dy)) {
      return i;
    }
  }
  return std::nullopt;
}

std::string place_text(double x, double y) {
  char text[64];
  std::snprintf(text, sizeof text, "%g, %g", x, y);
  return text;
}

class SelectTool : public Tool {
 public:
  void press(Editor& editor, const Pointer& pointer) override {
    start_ = pointer.at;
    levels_.clear();
    label_.reset();
    state_ = State::points;
    grabbed_.reset();
    if (has_tree(*editor.glyph())) {
      press_part(editor, pointer);
      return;
    }
    // Outlines of strokes have no points; knots are above those of contours.
    const Glyph own = own_part(*editor.glyph());
    if (knots_.press(editor, pointer)) {
      press_knot(editor);
      return;
    }
    if (const auto hit = point_near(own, pointer)) {
      press_point(editor, pointer, *hit);
      return;
    }
    if (knots_.press_line(editor, pointer)) {
      press_knot(editor);
      return;
    }
    const auto component = component_at(editor, pointer.at);
    editor.guide.reset();
    editor.component = component;
    if (const auto edge = nearest_on_curve(own, pointer.at, pointer.reach)) {
      press_edge(editor, pointer, *edge);
    } else if (component && pointer.twice) {
      state_ = State::idle;
      editor.show(editor.glyph()->components[*component].base);
    } else if (component) {
      editor.select_nothing();
      editor.component = component;
      state_ = State::component;
    } else if (const auto guide = guide_near(own, pointer)) {
      editor.select_nothing();
      editor.guide = guide;
      state_ = State::guide;
    } else {
      if (!pointer.shift) {
        editor.select_nothing();
      }
      kept_ = editor.selection;
      kept_knots_ = editor.knots;
      end_ = start_;
      state_ = State::box;
    }
  }

  void drag(Editor& editor, const Pointer& pointer) override {
    double dx = std::round(pointer.at.x - start_.x);
    double dy = std::round(pointer.at.y - start_.y);
    if (state_ == State::part && !editor.part) {
      return;  // an undo or another press took it
    }
    const bool is_flat = std::abs(dx) >= std::abs(dy);
    if (pointer.shift) {
      (is_flat ? dy : dx) = 0;
    }
    levels_.clear();
    label_.reset();
    if (state_ == State::points) {
      drag_points(editor, pointer, {dx, dy}, is_flat);
    } else if (state_ == State::nib) {
      label_ = {pointer.at, knots_.drag_nib(editor, pointer)};
    } else if (state_ == State::part) {
      Matrix move;
      move.dx = dx;
      move.dy = dy;
      editor.propose(map_part(*editor.stored(), *editor.part, move));
    } else if (state_ == State::component) {
      const bool moves = dx != 0 || dy != 0;
      editor.propose(moves ? move_component(editor, dx, dy) : Value());
    } else if (state_ == State::guide) {
      const Guideline& line = editor.stored()->guidelines[*editor.guide];
      label_ = {pointer.at,
                place_text(line.x.value_or(0) + dx, line.y.value_or(0) + dy)};
      editor.propose(move_guide(editor, dx, dy));
    } else if (state_ == State::box) {
      end_ = pointer.at;
      select_box(editor);
    }
  }

  void release(Editor& editor, const Pointer&) override {
    stop();
    editor.commit();
  }

  void cancel(Editor& editor) override {
    stop();
    editor.propose(nullptr);
  }

  Marks marks(const Editor&) const override {
    Marks marks;
    if (state_ == State::box) {
      marks.box = {start_, end_};
    }
    marks.levels = levels_;
    if (label_) {
      marks.labels.push_back(*label_);
    }
    return marks;
  }

 private:
  enum class State { idle, points, nib, part, component, guide, box };

  void stop() {
    state_ = State::idle;
    levels_.clear();
    label_.reset();
  }

  // The parts of a glyph move, not the points of the result. A double click
  // opens a part.
  void press_part(Editor& editor, const Pointer& pointer) {
    editor.select_nothing();
    const GlyphPointer glyph = editor.glyph();
    const auto part = part_at(editor.project(), *glyph, pointer.at);
    state_ = part ? State::part : State::idle;
    if (part && pointer.twice) {
      editor.show(parts_of(*glyph)[*part].value("glyph", ""));
      return;
    }
    editor.part = part;
  }

  // A knot, or the handle of a nib.
  void press_knot(Editor& editor) {
    editor.component.reset();
    editor.guide.reset();
    if (knots_.is_at_nib()) {
      state_ = State::nib;
    }
  }

  void press_point(Editor& editor, const Pointer& pointer, PointId hit) {
    editor.component.reset();
    editor.guide.reset();
    grabbed_ = hit;
    if (pointer.twice) {
      const Value command = toggle_smooth(*editor.glyph(), hit);
      if (!command.is_null()) {
        editor.run(command);
      }
      state_ = State::idle;
    } else if (pointer.shift && editor.selection.count(hit) != 0) {
      editor.selection.erase(hit);
    } else {
      if (!pointer.shift && editor.selection.count(hit) == 0) {
        editor.select_nothing();
      }
      editor.selection.insert(hit);
    }
  }

  // Alt converts a line to a curve; a double click selects the whole contour.
  void press_edge(Editor& editor, const Pointer& pointer, const OnCurve& edge) {
    const GlyphPointer glyph = editor.glyph();
    const auto end = end_of_line(*glyph, edge);
    if (pointer.alt && end) {
      editor.select_nothing();
      editor.run(curve_line(*glyph, *end));
      state_ = State::idle;
      return;
    }
    editor.knots.clear();
    if (pointer.twice) {
      editor.select_contour(edge.contour);
    } else {
      editor.selection = points_of(*glyph, edge);
    }
    // The selected on-curve point next to the pointer snaps.
    double nearest = INFINITY;
    for (const PointId id : editor.selection) {
      const GlyphPoint& p = glyph->contours[id.contour].points[id.point];
      const double d = distance(pointer.at, {p.x, p.y});
      if (p.on_curve() && d < nearest) {
        nearest = d;
        grabbed_ = id;
      }
    }
  }

  // The pressed point or knot in the project; nothing if it was deselected.
  std::optional<Point> pressed(const Editor& editor) const {
    if (!grabbed_) {
      return knots_.knot(editor);
    }
    if (editor.selection.count(*grabbed_) == 0) {
      return std::nullopt;
    }
    const GlyphPoint& point =
        editor.stored()->contours[grabbed_->contour].points[grabbed_->point];
    return Point{point.x, point.y};
  }

  void drag_points(Editor& editor,
                   const Pointer& pointer,
                   Point move,
                   bool is_flat) {
    const auto from = pressed(editor);
    if (!from) {
      return;
    }
    const bool moves = move.x != 0 || move.y != 0;
    if (moves && !pointer.free) {
      const Snap snapped =
          snap(editor, *from, move, kSnapPart * pointer.reach,
               pointer.shift && !is_flat, pointer.shift && is_flat);
      move = {snapped.dx, snapped.dy};
      levels_ = snapped.lines;
    }
    const Point to = {from->x + move.x, from->y + move.y};
    label_ = {to, place_text(to.x, to.y)};
    editor.propose(moves ? move_selected(editor, move) : Value());
  }

  static Value move_guide(const Editor& editor, double dx, double dy) {
    const GlyphPointer glyph = editor.stored();
    const Guideline& line = glyph->guidelines[*editor.guide];
    Value command = {{"do", "set_guideline"}, {"guideline", *editor.guide}};
    if (line.x) {
      command["x"] = *line.x + dx;
    }
    if (line.y) {
      command["y"] = *line.y + dy;
    }
    if (line.angle) {
      command["angle"] = *line.angle;
    }
    return command;
  }

  static Value move_component(const Editor& editor, double dx, double dy) {
    const GlyphPointer glyph = editor.stored();
    const Matrix& m = glyph->components[*editor.component].matrix;
    return {{"do", "set_component"},
            {"component", *editor.component},
            {"matrix", {m.xx, m.xy, m.yx, m.yy, m.dx + dx, m.dy + dy}}};
  }

  void select_box(Editor& editor) const {
    const Glyph own = own_part(*editor.glyph());
    select_knots(editor, kept_knots_, start_, end_);
    editor.selection = kept_;
    const auto [x0, x1] = std::minmax(start_.x, end_.x);
    const auto [y0, y1] = std::minmax(start_.y, end_.y);
    for (size_t c = 0; c < own.contours.size(); ++c) {
      const std::vector<GlyphPoint>& points = own.contours[c].points;
      for (size_t p = 0; p < points.size(); ++p) {
        if (points[p].x >= x0 && points[p].x <= x1 && points[p].y >= y0 &&
            points[p].y <= y1) {
          editor.selection.insert({c, p});
        }
      }
    }
  }

  State state_ = State::idle;
  Point start_;
  Point end_;
  Selection kept_;  // before the box
  Selection kept_knots_;
  std::optional<PointId> grabbed_;  // the point under the pointer, if it is one
  KnotDrag knots_;
  std::vector<std::pair<Point, Point>> levels_;
  std::optional<std::pair<Point, std::string>> label_;
};

}  // namespace

std::unique_ptr<Tool> make_select_tool() {
  return std::make_unique<SelectTool>();
}

}  // namespace inkcell::design::editor
