// The pointer of the Select tool on glyphs that are made of strokes.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "editor/editor.hpp"
#include "editor/strokes.hpp"

namespace inkcell::design::editor {

/// Selects and drags knots of centre lines, and the handles of nibs.
class KnotDrag {
 public:
  /// False if there is nothing to drag near the pointer. A double click makes a
  /// knot a corner, and adds one to a centre line.
  bool press(Editor& editor, const Pointer& pointer);
  /// Proposes the change of a pointer that moved by `move`.
  void drag(Editor& editor, const Pointer& pointer, Point move);

  /// Where something was dragged to.
  std::optional<std::pair<Point, std::string>> label;

 private:
  enum class Grip { none, knots, along, across };

  bool press_handle(const Editor& editor, const Pointer& pointer);
  bool press_knot(Editor& editor, const Pointer& pointer);
  bool press_line(Editor& editor, const Pointer& pointer);

  Grip grip_ = Grip::none;
  PointId grabbed_;
};

/// Selects the knots in a box, in addition to `kept`.
void select_knots(Editor& editor, const Selection& kept, Point a, Point b);

}  // namespace inkcell::design::editor
