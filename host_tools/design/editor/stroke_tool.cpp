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
    path_ = {{std::round(pointer.at.x), std::round(pointer.at.y)}};
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
    path_.clear();
    editor.commit();
    if (is_drawn) {
      editor.message = {"Added a stroke; the Select tool moves its knots"};
    }
  }

  void cancel(Editor& editor) override {
    path_.clear();
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
    const GlyphPointer glyph = editor.stored();
    Value points = Value::array();
    for (const StrokePoint& knot : knots_of(path_, kLoosePart * reach_)) {
      Value point = {knot.at.x, knot.at.y};
      if (knot.is_corner) {
        point = {knot.at.x, knot.at.y, nullptr, nullptr, nullptr, "corner"};
      }
      points.push_back(point);
    }
    const Value stroke = {
        {"nib", editor.nib.text()}, {"points", points}, {"smooth", true}};
    Value strokes = glyph->lib.value(kStrokesKey, Value::array());
    strokes.push_back(stroke);
    return {{"do", "set_strokes"}, {"strokes", strokes}};
  }

  std::vector<Point> path_;
  double reach_ = 0;  // of the pointer
};

}  // namespace

std::unique_ptr<Tool> make_stroke_tool() {
  return std::make_unique<StrokeTool>();
}

}  // namespace inkcell::design::editor
