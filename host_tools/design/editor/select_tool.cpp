// Selecting and dragging of points, edges and components.
#include <algorithm>
#include <cmath>

#include "editor/edits.hpp"
#include "editor/segments.hpp"
#include "editor/tool.hpp"

namespace inkcell::design::editor {
namespace {

double distance(Point a, Point b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// On-curve points before handles, where both are hit.
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

// Points of the contour at the ends and handles of a segment.
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
    append_component(editor.project(), 0, glyph->components[i], part.contours);
    // Inside if a line to the left crosses the contours an odd number of times.
    const Point far = {at.x - 1e5, at.y + 0.25};
    if (crossings(part.contours, {at.x, at.y + 0.25}, far).size() % 2 != 0) {
      return i;
    }
  }
  return std::nullopt;
}

class SelectTool : public Tool {
 public:
  void press(Editor& editor, const Pointer& pointer) override {
    start_ = pointer.at;
    state_ = State::points;
    const GlyphPointer glyph = editor.glyph();
    if (const auto hit = point_near(*glyph, pointer)) {
      press_point(editor, pointer, *hit);
      return;
    }
    editor.component = component_at(editor, pointer.at);
    if (const auto edge = nearest_on_curve(*glyph, pointer.at, pointer.reach)) {
      editor.selection = points_of(*glyph, *edge);
    } else if (editor.component) {
      editor.selection.clear();
      state_ = State::component;
    } else {
      if (!pointer.shift) {
        editor.selection.clear();
      }
      kept_ = editor.selection;
      end_ = start_;
      state_ = State::box;
    }
  }

  void drag(Editor& editor, const Pointer& pointer) override {
    double dx = std::round(pointer.at.x - start_.x);
    double dy = std::round(pointer.at.y - start_.y);
    if (pointer.shift) {
      (std::abs(dx) < std::abs(dy) ? dx : dy) = 0;
    }
    const bool moves = dx != 0 || dy != 0;
    if (state_ == State::points) {
      const GlyphPointer glyph = editor.project().find(editor.glyph_name());
      editor.propose(moves ? move_selection(*glyph, editor.selection, dx, dy)
                           : Value());
    } else if (state_ == State::component) {
      editor.propose(moves ? move_component(editor, dx, dy) : Value());
    } else if (state_ == State::box) {
      end_ = pointer.at;
      select_box(editor);
    }
  }

  void release(Editor& editor, const Pointer&) override {
    state_ = State::idle;
    editor.commit();
  }

  void cancel(Editor& editor) override {
    state_ = State::idle;
    editor.propose(nullptr);
  }

  Marks marks(const Editor&) const override {
    Marks marks;
    if (state_ == State::box) {
      marks.box = {start_, end_};
    }
    return marks;
  }

 private:
  enum class State { idle, points, component, box };

  void press_point(Editor& editor, const Pointer& pointer, PointId hit) {
    editor.component.reset();
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
        editor.selection.clear();
      }
      editor.selection.insert(hit);
    }
  }

  static Value move_component(const Editor& editor, double dx, double dy) {
    const GlyphPointer glyph = editor.project().find(editor.glyph_name());
    const Matrix& m = glyph->components[*editor.component].matrix;
    return {{"do", "set_component"},
            {"component", *editor.component},
            {"matrix", {m.xx, m.xy, m.yx, m.yy, m.dx + dx, m.dy + dy}}};
  }

  void select_box(Editor& editor) const {
    editor.selection = kept_;
    const GlyphPointer glyph = editor.glyph();
    const auto [x0, x1] = std::minmax(start_.x, end_.x);
    const auto [y0, y1] = std::minmax(start_.y, end_.y);
    for (size_t c = 0; c < glyph->contours.size(); ++c) {
      const std::vector<GlyphPoint>& points = glyph->contours[c].points;
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
  Selection kept_;
};

}  // namespace

std::unique_ptr<Tool> make_select_tool() {
  return std::make_unique<SelectTool>();
}

}  // namespace inkcell::design::editor
