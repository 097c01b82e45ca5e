// Freehand strokes of a nib.
#include <cmath>

#include "editor/editor.hpp"
#include "editor/tool.hpp"
#include "model/sources.hpp"
#include "stroke/smooth_path.hpp"

namespace inkcell::design::editor {
namespace {

// The part of the pointer's reach by which a stroke may leave what was drawn.
constexpr double kLoosePart = 0.25;

class StrokeTool : public Tool {
 public:
  void press(Editor&, const Pointer& pointer) override {
    path_.clear();
    if (!pointer.twice) {
      path_ = {{std::round(pointer.at.x), std::round(pointer.at.y)}};
    }
    is_continued_ = is_continued_ && !pointer.twice;
  }

  void drag(Editor& editor, const Pointer& pointer) override {
    if (path_.empty()) {
      return;
    }
    const Point at = {std::round(pointer.at.x), std::round(pointer.at.y)};
    reach_ = pointer.reach;
    if (std::hypot(at.x - path_.back().x, at.y - path_.back().y) >=
        pointer.reach) {
      path_.push_back(at);
      editor.propose(command(editor));
    }
  }

  void release(Editor& editor, const Pointer&) override {
    const bool is_drawn = path_.size() > 1;
    const bool is_clicked = path_.size() == 1;
    if (is_clicked) {
      editor.propose(command(editor));
    }
    path_.clear();
    editor.commit();
    is_continued_ = is_clicked;
    if (is_drawn) {
      editor.message = {"Added a stroke; the Select tool moves its knots"};
    }
  }

  void cancel(Editor& editor) override {
    path_.clear();
    is_continued_ = false;
    editor.propose(nullptr);
  }

  Marks marks(const Editor&) const override {
    Marks marks;
    for (size_t i = 1; i < path_.size(); ++i) {
      marks.lines.push_back({path_[i - 1], path_[i]});
    }
    return marks;
  }

 private:
  Value command(const Editor& editor) const {
    Value strokes = editor.stored()->lib.value(kStrokesKey, Value::array());
    Value points = Value::array();
    for (const StrokePoint& knot : knots_of(path_, kLoosePart * reach_)) {
      Value point = {knot.at.x, knot.at.y};
      if (knot.is_corner) {
        point = {knot.at.x, knot.at.y, nullptr, nullptr, nullptr, "corner"};
      }
      points.push_back(point);
    }
    if (path_.size() == 1 && is_continued_) {
      strokes.back()["points"].push_back(points[0]);
    } else {
      strokes.push_back(
          {{"nib", editor.nib.text()}, {"points", points}, {"smooth", true}});
    }
    return {{"do", "set_strokes"}, {"strokes", strokes}};
  }

  std::vector<Point> path_;
  double reach_ = 0;           // of the pointer
  bool is_continued_ = false;  // the last stroke, by the next click
};

}  // namespace

std::unique_ptr<Tool> make_stroke_tool() {
  return std::make_unique<StrokeTool>();
}

}  // namespace inkcell::design::editor
