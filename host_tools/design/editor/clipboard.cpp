#include "editor/clipboard.hpp"

#include <algorithm>

#include "editor/edits.hpp"
#include "model/error.hpp"
#include "model/sources.hpp"

namespace inkcell::design::editor {
namespace {

Value matrix_value(const Matrix& m) {
  return {m.xx, m.xy, m.yx, m.yy, m.dx, m.dy};
}

// The parts of a contour between selected on-curve neighbours.
class Pieces {
 public:
  Pieces(const PointContour& contour, const std::vector<bool>& selected)
      : contour_(contour), selected_(selected) {}

  std::vector<PointContour> find() {
    const size_t count = contour_.points.size();
    // Starts at a point between two parts, if there is one.
    size_t first = 0;
    while (!contour_.open() && first < count && !divides(first)) {
      ++first;
    }
    if (first == count) {
      return {contour_};
    }
    for (size_t i = 0; i < count; ++i) {
      add((first + i) % count);
    }
    end_piece();
    return std::move(pieces_);
  }

 private:
  bool divides(size_t point) const {
    return contour_.points[point].on_curve() && !selected_[point];
  }

  void add(size_t index) {
    const GlyphPoint& point = contour_.points[index];
    if (!point.on_curve()) {
      handles_.push_back(point);
      return;
    }
    if (!selected_[index]) {
      end_piece();
      return;
    }
    if (piece_.points.empty()) {
      piece_.points.push_back(point);
      piece_.points.front().type = PointType::move;
    } else {
      piece_.points.insert(piece_.points.end(), handles_.begin(),
                           handles_.end());
      piece_.points.push_back(point);
    }
    handles_.clear();
  }

  void end_piece() {
    if (piece_.points.size() > 1) {
      pieces_.push_back(std::move(piece_));
    }
    piece_ = {};
    handles_.clear();
  }

  const PointContour& contour_;
  const std::vector<bool>& selected_;
  std::vector<PointContour> pieces_;
  PointContour piece_;
  std::vector<GlyphPoint> handles_;
};

std::vector<PointContour> selected_contours(const Glyph& glyph,
                                            const Selection& selection) {
  std::vector<PointContour> result;
  for (size_t c = 0; c < glyph.contours.size(); ++c) {
    const PointContour& contour = glyph.contours[c];
    std::vector<bool> selected(contour.points.size(), selection.empty());
    for (const PointId id : selection) {
      if (id.contour == c) {
        selected[id.point] = true;
      }
    }
    if (std::count(selected.begin(), selected.end(), true) != 0) {
      for (PointContour& piece : Pieces(contour, selected).find()) {
        result.push_back(std::move(piece));
      }
    }
  }
  return result;
}

[[noreturn]] void refuse() {
  throw Error("the clipboard holds no contours");
}

// Moves what a command adds. Throws if copy_of() does not make such commands.
void move_added(const Project& project, Value& command, double dx, double dy) {
  const std::string name = command.value("do", "");
  if (name == "add_contour") {
    for (Value& point : command.at("points")) {
      point.at(0) = point.at(0).get<double>() + dx;
      point.at(1) = point.at(1).get<double>() + dy;
    }
  } else if (name == "add_component") {
    project.glyph(command.at("base").get<std::string>());
    Value& matrix = command.at("matrix");
    matrix.at(4) = matrix.at(4).get<double>() + dx;
    matrix.at(5) = matrix.at(5).get<double>() + dy;
  } else {
    refuse();
  }
}

}  // namespace

std::string copy_of(const Editor& editor) {
  const GlyphPointer glyph = editor.glyph();
  std::vector<Value> commands;
  const bool is_all = editor.selection.empty() && !editor.component;
  if (!editor.component) {
    for (const PointContour& contour :
         selected_contours(*glyph, editor.selection)) {
      commands.push_back(add_contour(contour));
    }
  }
  for (size_t i = 0; i < glyph->components.size(); ++i) {
    if (is_all || editor.component == i) {
      const ComponentUse& use = glyph->components[i];
      commands.push_back({{"do", "add_component"},
                          {"base", use.base},
                          {"matrix", matrix_value(use.matrix)}});
    }
  }
  return commands.empty() ? "" : batch(std::move(commands)).dump();
}

void paste(Editor& editor, const std::string& text, double dx, double dy) {
  Value command = Value::parse(text, nullptr, false);
  if (!command.is_object()) {
    refuse();
  }
  try {
    Value single = Value::array({command});
    const bool is_batch = command.value("do", "") == "batch";
    for (Value& part : is_batch ? command.at("commands") : single) {
      move_added(editor.project(), part, dx, dy);
    }
    command = is_batch ? command : single[0];
  } catch (const Value::exception&) {
    refuse();
  }
  const GlyphPointer before = editor.stored();
  editor.tool().cancel(editor);
  editor.run(command);
  const GlyphPointer after = editor.glyph();
  editor.selection.clear();
  editor.component.reset();
  for (size_t c = own_contours(*before); c < own_contours(*after); ++c) {
    editor.select_contour(c);
  }
  if (editor.selection.empty() &&
      after->components.size() > before->components.size()) {
    editor.component = after->components.size() - 1;
  }
}

}  // namespace inkcell::design::editor
