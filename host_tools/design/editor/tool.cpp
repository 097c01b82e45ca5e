#include "editor/tool.hpp"

namespace inkcell::design::editor {

const std::vector<ToolInfo>& tool_list() {
  static const std::vector<ToolInfo> list = {
      {ToolKind::select, "Select", "v",
       "Drag points and edges; Shift keeps to an axis, Ctrl does not snap; "
       "Alt makes a line a curve"},
      {ToolKind::pen, "Pen", "p",
       "Click for corners, drag for curves, click the first point to close; "
       "click on an edge to add a point"},
      {ToolKind::knife, "Knife", "e", "Drag a line that cuts contours"},
      {ToolKind::rectangle, "Rectangle", "r",
       "Drag a rectangle; Shift makes a square"},
      {ToolKind::ellipse, "Ellipse", "o",
       "Drag an ellipse; Shift makes a circle"},
      {ToolKind::stroke, "Stroke", "b",
       "Draw a stroke with the nib, or click its knots; a double click ends "
       "it"},
      {ToolKind::measure, "Measure", "l",
       "Drag a line; its length and what it passes through are shown"},
      {ToolKind::spacing, "Spacing", "t",
       "Drag a glyph of the line to kern its group, with Alt only the pair; "
       "drag a dashed line for a side bearing"},
  };
  return list;
}

std::unique_ptr<Tool> make_tool(ToolKind kind) {
  switch (kind) {
    case ToolKind::pen:
      return make_pen_tool();
    case ToolKind::knife:
      return make_knife_tool();
    case ToolKind::rectangle:
    case ToolKind::ellipse:
      return make_shape_tool(kind);
    case ToolKind::stroke:
      return make_stroke_tool();
    case ToolKind::spacing:
      return make_spacing_tool();
    case ToolKind::measure:
      return make_measure_tool();
    default:
      return make_select_tool();
  }
}

}  // namespace inkcell::design::editor
