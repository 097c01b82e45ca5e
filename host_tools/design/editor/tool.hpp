// Tools: the effect of the pointer on the canvas.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "shape/outline.hpp"

namespace inkcell::design::editor {

using gen::Point;

class Editor;

enum class ToolKind {
  select,
  pen,
  knife,
  rectangle,
  ellipse,
  stroke,
  measure,
  spacing,
};

/// A tool's name and help.
struct ToolInfo {
  ToolKind kind;
  const char* name;
  const char* key;
  const char* hint;
};
const std::vector<ToolInfo>& tool_list();

/// The distance within which the pointer hits things. [px at scale 1]
inline constexpr double kReach = 7;

struct Pointer {
  Point at;          // [font units]
  double reach = 0;  // kReach at the scale of the view [font units]
  bool shift = false;
  bool alt = false;
  bool free = false;   // does not snap
  bool twice = false;  // the second press of a double click
};

/// Marks of a tool over the canvas. [font units]
struct Marks {
  std::vector<std::pair<Point, Point>> lines;
  std::vector<std::pair<Point, Point>> levels;  // points that are level
  std::optional<std::pair<Point, Point>> box;
  std::vector<Point> dots;
  std::vector<std::pair<Point, std::string>> labels;
};

class Tool {
 public:
  virtual ~Tool() = default;

  virtual void press(Editor& editor, const Pointer& pointer) = 0;
  virtual void drag(Editor& editor, const Pointer& pointer) = 0;
  virtual void release(Editor& editor, const Pointer& pointer) = 0;
  /// Ends an operation that has begun.
  virtual void cancel(Editor& editor) = 0;
  /// Ends a press of the pointer because the glyph changes, so that what it
  /// pointed at is no longer valid.
  virtual void interrupt(Editor& editor) { cancel(editor); }
  virtual Marks marks(const Editor& editor) const = 0;
};

std::unique_ptr<Tool> make_tool(ToolKind kind);

// Makes the tools, which are defined in files of their own.
std::unique_ptr<Tool> make_select_tool();
std::unique_ptr<Tool> make_pen_tool();
std::unique_ptr<Tool> make_knife_tool();
std::unique_ptr<Tool> make_measure_tool();
std::unique_ptr<Tool> make_shape_tool(ToolKind kind);
std::unique_ptr<Tool> make_stroke_tool();
std::unique_ptr<Tool> make_spacing_tool();

}  // namespace inkcell::design::editor
