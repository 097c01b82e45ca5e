// The pointer of the Select tool on glyphs that are made of strokes.
#pragma once

#include <optional>
#include <string>

#include "editor/editor.hpp"
#include "editor/strokes.hpp"

namespace inkcell::design::editor {

/// Selects and drags knots of centre lines, and the handles of nibs.
class KnotDrag {
 public:
  /// Presses the handle of a nib, or a knot. False if none is near the pointer.
  /// A double click makes a knot a corner.
  bool press(Editor& editor, const Pointer& pointer);
  /// Presses a centre line; likewise. A double click adds a knot.
  bool press_line(Editor& editor, const Pointer& pointer);

  bool is_at_nib() const {
    return grip_ == Grip::along || grip_ == Grip::across;
  }
  /// Proposes the nib of a pointer at its handle. Returns what it says.
  std::string drag_nib(Editor& editor, const Pointer& pointer) const;
  /// The place of the pressed knot in the project; nothing if there is none, or
  /// it was deselected.
  std::optional<Point> knot(const Editor& editor) const;

 private:
  enum class Grip { none, knots, along, across };

  bool press_handle(const Editor& editor, const Pointer& pointer);
  bool press_knot(Editor& editor, const Pointer& pointer);

  Grip grip_ = Grip::none;
  PointId grabbed_;
};

/// Selects the knots in a box, in addition to `kept`.
void select_knots(Editor& editor, const Selection& kept, Point a, Point b);

}  // namespace inkcell::design::editor
