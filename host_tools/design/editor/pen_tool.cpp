// Draws contours point by point.
#include <cmath>

#include "editor/edits.hpp"
#include "editor/segments.hpp"
#include "editor/tool.hpp"
#include "model/commands.hpp"
#include "model/sources.hpp"

namespace inkcell::design::editor {
namespace {

Point rounded(Point p) {
  return {std::round(p.x), std::round(p.y)};
}

bool is_near(const GlyphPoint& point, const Pointer& pointer) {
  return std::hypot(point.x - pointer.at.x, point.y - pointer.at.y) <
         pointer.reach;
}

Value off_curve(Point p) {
  return {p.x, p.y, "offcurve"};
}

class PenTool : public Tool {
 public:
  void press(Editor& editor, const Pointer& pointer) override {
    at_ = rounded(pointer.at);
    handle_.reset();
    is_pressed_ = true;
    const GlyphPointer glyph = editor.glyph();
    if (!draws(*glyph)) {
      contour_.reset();
      leaving_.reset();
      if (continues(editor, pointer) || adds_point(editor, pointer)) {
        is_pressed_ = false;
        return;
      }
    }
    is_closing_ = false;
    if (contour_) {
      const std::vector<GlyphPoint>& points = glyph->contours[*contour_].points;
      is_closing_ = points.size() > 1 && is_near(points.front(), pointer);
      if (is_closing_) {
        at_ = {points.front().x, points.front().y};
      }
    }
    editor.propose(command(editor));
  }

  void drag(Editor& editor, const Pointer& pointer) override {
    if (!is_pressed_) {
      return;
    }
    const Point to = rounded(pointer.at);
    if (std::hypot(to.x - at_.x, to.y - at_.y) < pointer.reach) {
      return;
    }
    handle_ = to;
    editor.propose(command(editor));
  }

  void release(Editor& editor, const Pointer&) override {
    if (!is_pressed_) {
      return;
    }
    is_pressed_ = false;
    const size_t count = own_contours(*editor.stored());
    editor.commit();
    if (is_closing_) {
      contour_.reset();
      leaving_.reset();
      return;
    }
    contour_ = contour_.value_or(count);
    leaving_ = handle_;
  }

  void cancel(Editor& editor) override {
    is_pressed_ = false;
    contour_.reset();
    leaving_.reset();
    editor.propose(nullptr);
  }

  void interrupt(Editor& editor) override {
    is_pressed_ = false;
    editor.propose(nullptr);
  }

  Marks marks(const Editor& editor) const override {
    Marks marks;
    const GlyphPointer glyph = editor.glyph();
    if (contour_ && *contour_ < glyph->contours.size() && leaving_) {
      const GlyphPoint& last = glyph->contours[*contour_].points.back();
      marks.lines.push_back({{last.x, last.y}, *leaving_});
      marks.dots.push_back(*leaving_);
    }
    if (is_pressed_ && handle_) {
      marks.lines.push_back({at_, *handle_});
      marks.dots.push_back(*handle_);
    }
    return marks;
  }

 private:
  bool draws(const Glyph& glyph) const {
    return contour_ && *contour_ < glyph.contours.size() &&
           glyph.contours[*contour_].open();
  }

  // Whether the pointer continues an open contour, at its end or its start.
  bool continues(Editor& editor, const Pointer& pointer) {
    const Glyph& glyph = *editor.glyph();
    for (size_t i = 0; i < glyph.contours.size() && !contour_; ++i) {
      const std::vector<GlyphPoint>& points = glyph.contours[i].points;
      const bool is_end = is_near(points.back(), pointer);
      if (glyph.contours[i].open() &&
          (is_end || is_near(points.front(), pointer))) {
        contour_ = i;
        if (!is_end) {
          editor.run({{"do", "reverse_contour"}, {"contour", i}});
        }
      }
    }
    return contour_.has_value();
  }

  static bool adds_point(Editor& editor, const Pointer& pointer) {
    const Glyph glyph = own_part(*editor.glyph());
    const auto place = nearest_on_curve(glyph, pointer.at, pointer.reach);
    if (!place || glyph.contours[place->contour].open()) {
      return false;
    }
    std::vector<PointContour> contours = glyph.contours;
    contours[place->contour] = with_point(contours[place->contour], *place);
    editor.run(replace_contours(glyph, contours, "Add point"));
    return true;
  }

  // The handle before the point at at_.
  std::optional<Point> arriving() const {
    return handle_ ? std::optional<Point>(
                         Point{2 * at_.x - handle_->x, 2 * at_.y - handle_->y})
                   : std::nullopt;
  }

  // A contour that is closed gets the direction of the others.
  Value turn_over(const Editor& editor, const Value& closing) const {
    const Change change =
        change_of(editor.project(), for_glyph(editor, closing));
    const Glyph& closed = *change.glyphs[0].after;
    const GlyphPointer before = editor.stored();
    const bool is_wrong = (twice_area(closed.contours[*contour_]) < 0) !=
                          is_clockwise(editor.project(), *before);
    const Value turn = {{"do", "reverse_contour"}, {"contour", *contour_}};
    return is_wrong ? batch({closing, turn}) : closing;
  }

  Value command(const Editor& editor) const {
    const Glyph& glyph = *editor.stored();
    if (!contour_) {
      return {{"do", "add_contour"},
              {"points", Value::array({Value{at_.x, at_.y, "move"}})}};
    }
    const std::vector<GlyphPoint>& points = glyph.contours[*contour_].points;
    const bool is_curve = leaving_ || handle_;
    Value added = Value::array();
    if (is_curve) {
      added.push_back(off_curve(
          leaving_.value_or(Point{points.back().x, points.back().y})));
      added.push_back(off_curve(arriving().value_or(at_)));
    }
    const char* type = is_curve ? "curve" : "line";
    if (!is_closing_) {
      Value point = {at_.x, at_.y, type};
      if (handle_) {
        point.push_back("smooth");
      }
      added.push_back(point);
    }
    std::vector<Value> commands;
    if (is_closing_) {
      commands.push_back({{"do", "set_point"},
                          {"contour", *contour_},
                          {"point", 0},
                          {"type", type},
                          {"smooth", handle_.has_value()}});
    }
    if (!added.empty()) {
      commands.push_back({{"do", "insert_points"},
                          {"contour", *contour_},
                          {"at", points.size()},
                          {"points", added}});
    }
    const Value all = batch(std::move(commands));
    return is_closing_ ? turn_over(editor, all) : all;
  }

  std::optional<size_t> contour_;  // being drawn
  std::optional<Point> leaving_;   // the handle after its last point
  std::optional<Point> handle_;    // after the point at at_
  Point at_;
  bool is_pressed_ = false;
  bool is_closing_ = false;
};

}  // namespace

std::unique_ptr<Tool> make_pen_tool() {
  return std::make_unique<PenTool>();
}

}  // namespace inkcell::design::editor
