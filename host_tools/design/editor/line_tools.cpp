// Tools that drag a line: knife, measure, shapes.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/edits.hpp"
#include "editor/segments.hpp"
#include "editor/tool.hpp"
#include "model/sources.hpp"
#include "shape/points.hpp"

namespace inkcell::design::editor {
namespace {

// The end of a line from `a`: `b`, or on the nearer axis.
Point constrained(Point a, Point b, bool to_axis) {
  if (!to_axis) {
    return b;
  }
  return std::abs(b.x - a.x) < std::abs(b.y - a.y) ? Point{a.x, b.y}
                                                   : Point{b.x, a.y};
}

std::string length_text(Point a, Point b) {
  char text[64];
  std::snprintf(text, sizeof text, "%.0f", std::hypot(b.x - a.x, b.y - a.y));
  return text;
}

std::vector<PointContour> all_contours(const Editor& editor) {
  const GlyphPointer glyph = editor.glyph();
  std::vector<PointContour> contours = glyph->contours;
  for (const ComponentUse& use : glyph->components) {
    append_component(editor.shown_project(), 0, use, contours);
  }
  return contours;
}

class LineTool : public Tool {
 public:
  void press(Editor& editor, const Pointer& pointer) override {
    is_pressed_ = true;
    a_ = b_ = pointer.at;
    changed(editor, pointer);
  }
  void drag(Editor& editor, const Pointer& pointer) override {
    if (is_pressed_) {
      b_ = pointer.at;
      changed(editor, pointer);
    }
  }
  void release(Editor& editor, const Pointer&) override {
    if (is_pressed_) {
      is_pressed_ = false;
      finish(editor);
    }
  }
  void cancel(Editor& editor) override {
    interrupt(editor);
    a_ = b_;
  }
  void interrupt(Editor& editor) override {
    is_pressed_ = false;
    editor.propose(nullptr);
  }

 protected:
  virtual void changed(Editor& editor, const Pointer& pointer) = 0;
  virtual void finish(Editor& editor) = 0;

  bool has_line() const { return a_.x != b_.x || a_.y != b_.y; }

  Point a_;
  Point b_;
  bool is_pressed_ = false;
};

class KnifeTool : public LineTool {
 public:
  Marks marks(const Editor& editor) const override {
    Marks marks;
    if (is_pressed_ && has_line()) {
      marks.lines.push_back({a_, b_});
      for (const OnCurve& place : crossings(editor.glyph()->contours, a_, b_)) {
        marks.dots.push_back(place.at);
      }
    }
    return marks;
  }

 private:
  void changed(Editor&, const Pointer& pointer) override {
    b_ = constrained(a_, b_, pointer.shift);
  }
  void finish(Editor& editor) override {
    const GlyphPointer glyph = editor.glyph();
    const Value command =
        replace_contours(*glyph, cut_contours(glyph->contours, a_, b_), "Cut");
    if (command.is_null()) {
      editor.message = {"The cut must begin and end outside the ink", true};
    } else {
      editor.selection.clear();
      editor.run(command);
    }
  }
};

class MeasureTool : public LineTool {
 public:
  Marks marks(const Editor& editor) const override {
    Marks marks;
    if (!has_line()) {
      return marks;
    }
    marks.lines.push_back({a_, b_});
    const std::vector<OnCurve> places = crossings(all_contours(editor), a_, b_);
    for (size_t i = 0; i < places.size(); ++i) {
      const Point at = places[i].at;
      marks.dots.push_back(at);
      if (i > 0) {
        const Point before = places[i - 1].at;
        marks.labels.push_back({{(before.x + at.x) / 2, (before.y + at.y) / 2},
                                length_text(before, at)});
      }
    }
    char angle[48];
    std::snprintf(angle, sizeof angle, "  %.1f\xc2\xb0",
                  180 / gen::kPi * std::atan2(b_.y - a_.y, b_.x - a_.x));
    marks.labels.push_back({b_, length_text(a_, b_) + angle});
    return marks;
  }

 private:
  void changed(Editor&, const Pointer& pointer) override {
    b_ = constrained(a_, b_, pointer.shift);
  }
  void finish(Editor&) override {}
};

class ShapeTool : public LineTool {
 public:
  explicit ShapeTool(ToolKind kind) : kind_(kind) {}

  Marks marks(const Editor&) const override {
    Marks marks;
    if (is_pressed_ && has_line()) {
      char text[64];
      std::snprintf(text, sizeof text, "%.0f x %.0f", std::abs(b_.x - a_.x),
                    std::abs(b_.y - a_.y));
      marks.labels.push_back({b_, text});
    }
    return marks;
  }

 private:
  void changed(Editor& editor, const Pointer& pointer) override {
    a_ = {std::round(a_.x), std::round(a_.y)};
    b_ = {std::round(b_.x), std::round(b_.y)};
    if (pointer.shift) {
      const double side =
          std::max(std::abs(b_.x - a_.x), std::abs(b_.y - a_.y));
      b_ = {a_.x + std::copysign(side, b_.x - a_.x),
            a_.y + std::copysign(side, b_.y - a_.y)};
    }
    const bool has_area = a_.x != b_.x && a_.y != b_.y;
    const bool is_box = kind_ == ToolKind::rectangle;
    editor.propose(has_area ? draw_contour(editor, is_box ? rectangle(a_, b_)
                                                          : ellipse(a_, b_))
                            : Value());
  }
  // What was drawn is selected.
  void finish(Editor& editor) override {
    const size_t before = own_contours(*editor.stored());
    editor.commit();
    if (own_contours(*editor.glyph()) > before) {
      editor.select_nothing();
      editor.select_contour(before);
    }
  }

  ToolKind kind_;
};

}  // namespace

std::unique_ptr<Tool> make_knife_tool() {
  return std::make_unique<KnifeTool>();
}

std::unique_ptr<Tool> make_measure_tool() {
  return std::make_unique<MeasureTool>();
}

std::unique_ptr<Tool> make_shape_tool(ToolKind kind) {
  return std::make_unique<ShapeTool>(kind);
}

}  // namespace inkcell::design::editor
