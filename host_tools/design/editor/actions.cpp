#include "editor/actions.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "editor/clipboard.hpp"
#include "editor/edits.hpp"
#include "editor/knot_drag.hpp"
#include "editor/parts.hpp"
#include "editor/strokes.hpp"
#include "model/error.hpp"
#include "model/sources.hpp"
#include "shape/shape.hpp"
#include "trace/field_outline.hpp"

namespace inkcell::design::editor {
namespace {

constexpr double kZoomStep = 1.25;
constexpr double kDuplicateStep = 0.02;  // [em]

void run_unless_null(Editor& editor, Value command) {
  if (!command.is_null()) {
    editor.run(std::move(command));
  }
}

void nudge(Editor& editor, double dx, double dy) {
  if (editor.part) {
    Matrix move;
    move.dx = dx;
    move.dy = dy;
    editor.run(map_part(*editor.glyph(), *editor.part, move));
    return;
  }
  if (editor.component) {
    const Matrix& m = editor.glyph()->components[*editor.component].matrix;
    editor.run({{"do", "set_component"},
                {"component", *editor.component},
                {"matrix", {m.xx, m.xy, m.yx, m.yy, m.dx + dx, m.dy + dy}}});
    return;
  }
  run_unless_null(editor, move_selected(editor, {dx, dy}));
}

void delete_selection(Editor& editor) {
  if (editor.part) {
    editor.run(delete_part(*editor.glyph(), *editor.part));
    return;
  }
  if (editor.guide) {
    editor.run({{"do", "delete_guideline"}, {"guideline", *editor.guide}});
    editor.guide.reset();
    return;
  }
  if (editor.component) {
    editor.run({{"do", "delete_component"}, {"component", *editor.component}});
    return;
  }
  const GlyphPointer glyph = editor.glyph();
  Value command = both(delete_knots(*glyph, editor.knots),
                       delete_points(*glyph, editor.selection));
  editor.select_nothing();
  run_unless_null(editor, std::move(command));
}

void delete_glyph(Editor& editor) {
  const std::string name = editor.glyph_name();
  const std::vector<std::string> order = glyph_order(editor.project());
  const auto at = std::find(order.begin(), order.end(), name);
  if (order.size() < 2) {
    throw Error("'" + name + "' is the only glyph of the font");
  }
  editor.run({{"do", "delete_glyph"}});
  editor.show(at + 1 == order.end() ? *(at - 1) : *(at + 1));
  editor.message = {"Deleted the glyph '" + name + "'"};
}

void select_all(Editor& editor) {
  const Point far = {INFINITY, INFINITY};
  select_knots(editor, {}, {-far.x, -far.y}, far);
  for (size_t c = 0; c < own_contours(*editor.glyph()); ++c) {
    editor.select_contour(c);
  }
}

void escape(Editor& editor) {
  editor.tool().cancel(editor);
  editor.select_nothing();
}

// False if there is nothing to copy.
bool copy(Editor& editor) {
  const std::string text = copy_of(editor);
  if (text.empty()) {
    return false;
  }
  editor.clipboard.write(text);
  return true;
}

void cut(Editor& editor) {
  const bool is_selected = editor.component || !editor.selection.empty();
  if (is_selected && copy(editor)) {
    delete_selection(editor);
  }
}

void duplicate(Editor& editor) {
  const std::string text = copy_of(editor);
  if (!text.empty()) {
    const double step =
        std::round(kDuplicateStep * editor.project().units_per_em());
    paste(editor, text, step, -step);
  }
}

// Through the first selected point, or the middle of the view.
void add_guide(Editor& editor, bool is_upright) {
  Point at = {editor.view.x, editor.view.y};
  if (!editor.selection.empty()) {
    const PointId id = *editor.selection.begin();
    const GlyphPoint& point =
        editor.glyph()->contours[id.contour].points[id.point];
    at = {point.x, point.y};
  }
  editor.run({{"do", "add_guideline"},
              {is_upright ? "x" : "y", std::round(is_upright ? at.x : at.y)}});
}

void reverse_selected(Editor& editor) {
  std::vector<Value> commands;
  for (const Value& contour : selected_contours(editor)) {
    commands.push_back({{"do", "reverse_contour"}, {"contour", contour}});
  }
  if (!commands.empty()) {
    editor.selection.clear();
    editor.run(batch(std::move(commands)));
  }
}

// Combines the selected contours with the others.
void combine(Editor& editor, const char* operation) {
  Value contours = selected_contours(editor);
  const size_t all = own_contours(*editor.glyph());
  if (std::string(operation) != "union" &&
      (contours.empty() || contours.size() == all)) {
    throw Error("select some of the contours; they are combined with the rest");
  }
  editor.selection.clear();
  editor.run({{"do", "combine_contours"},
              {"op", operation},
              {"contours", std::move(contours)}});
  editor.message = {std::to_string(all) + " contours became " +
                    std::to_string(own_contours(*editor.glyph()))};
}

// The glyph's own contours as the generator gets them.
gen::Shape own_shape(const Editor& editor) {
  Glyph own = *editor.glyph();
  own.components.clear();
  return gen::Shape(outline_of(editor.project(), own));
}

size_t point_count(const Glyph& glyph) {
  size_t count = 0;
  for (const PointContour& contour : glyph.contours) {
    count += contour.points.size();
  }
  return count;
}

void make_field_curves(Editor& editor) {
  constexpr double kStep_u = 1;  // between points where edges are compared
  const gen::Shape before = own_shape(editor);
  const size_t points = point_count(*editor.glyph());
  editor.selection.clear();
  editor.run({{"do", "curves_of_field"}});
  const double off = edge_error(before, own_shape(editor), kStep_u).worst *
                     editor.project().units_per_em() / gen::kUPerEm;
  char text[120];
  std::snprintf(text, sizeof text,
                "Curves from the field: %zu points became %zu, the edge moved "
                "by %.1f units at most",
                points, point_count(*editor.glyph()), off);
  editor.message = {text};
}

Action simple(const char* name, const char* command) {
  return {name, "", [command](Editor& e) { e.run(Value{{"do", command}}); }};
}

Action transformed(const char* name, const char* keys, const Value& matrix) {
  return {name, keys,
          [matrix](Editor& e) { e.run(transform_selection(e, matrix)); }};
}

// An action on the selected contours.
Action arranged(const char* name, const Value& command) {
  return {name, "", [command](Editor& e) {
            Value run = command;
            run["contours"] = selected_contours(e);
            e.run(run);
          }};
}

void zoom(Editor& editor, double factor) {
  View& view = editor.view;
  view.zoom(factor, {view.width / 2, view.height / 2});
}

std::vector<Action> make_list() {
  std::vector<Action> list = {
      {"Save", "ctrl+s", [](Editor& e) { e.save(); }},
      {"Undo", "ctrl+z", [](Editor& e) { e.undo(); }},
      {"Redo", "ctrl+y ctrl+shift+z", [](Editor& e) { e.redo(); }},
      {"Undo in this glyph", "u", [](Editor& e) { e.step_glyph(false); }},
      {"Redo in this glyph", "shift+u", [](Editor& e) { e.step_glyph(true); }},
      {"Cut", "ctrl+x", cut},
      {"Copy", "ctrl+c", [](Editor& e) { copy(e); }},
      {"Paste", "ctrl+v",
       [](Editor& e) { paste(e, e.clipboard.read(), 0, 0); }},
      {"Duplicate", "ctrl+d", duplicate},
      {"Delete", "delete backspace", delete_selection},
      {"Select all", "ctrl+a", select_all},
      {"Select none", "escape", escape},
      {"Smooth or corner", "s",
       [](Editor& e) {
         if (e.knots.size() == 1) {
           e.run(toggle_corner(*e.glyph(), *e.knots.begin()));
         } else if (e.selection.size() == 1) {
           run_unless_null(e, toggle_smooth(*e.glyph(), *e.selection.begin()));
         }
       }},
      {"Align points", "ctrl+shift+a",
       [](Editor& e) {
         run_unless_null(e, align_points(*e.glyph(), e.selection));
       }},
      {"Horizontal guide", "g", [](Editor& e) { add_guide(e, false); }},
      {"Vertical guide", "shift+g", [](Editor& e) { add_guide(e, true); }},
      {"Reverse contours", "", reverse_selected},
      simple("Round to whole units", "round_points"),
      {"Unite", "ctrl+u", [](Editor& e) { combine(e, "union"); }},
      {"Subtract", "ctrl+shift+d", [](Editor& e) { combine(e, "difference"); }},
      {"Intersect", "", [](Editor& e) { combine(e, "intersection"); }},
      {"Exclude", "", [](Editor& e) { combine(e, "exclusion"); }},
      transformed("Reflect left and right", "", {{"reflect", "x"}}),
      transformed("Reflect up and down", "", {{"reflect", "y"}}),
      transformed("Turn left", "", {{"turn", 90}}),
      transformed("Turn right", "", {{"turn", -90}}),
      {"Space letters", "",
       [](Editor& e) {
         Value command = {{"do", "space_letters"}};
         if (e.master() != 0) {
           command["layer"] = e.project().layers[e.master()].name;
         }
         e.run(std::move(command));
         e.message = {"Letters are as near to each other as n and o, H and O"};
       }},
      simple("Convert to cubics", "to_cubics"),
      {"Curves from the field", "", make_field_curves},
      {"Combine components", "ctrl+shift+u",
       [](Editor& e) { e.run(combine_components(*e.glyph())); }},
      {"Turn into outline", "", [](Editor& e) { e.make_outline(); }},
      simple("Decompose", "decompose"),
      {"Remove picture", "",
       [](Editor& e) {
         if (e.glyph()->image) {
           e.run({{"do", "set_image"}});
         }
       }},
      {"Delete glyph", "", delete_glyph},
      {"Revert", "", [](Editor& e) { e.revert(); }},
      {"Next glyph", "pagedown", [](Editor& e) { e.step(1); }},
      {"Previous glyph", "pageup", [](Editor& e) { e.step(-1); }},
      {"Fit glyph", "0 ctrl+0", [](Editor& e) { e.fit_view(); }},
      {"Zoom in", "= +", [](Editor& e) { zoom(e, kZoomStep); }},
      {"Zoom out", "-", [](Editor& e) { zoom(e, 1 / kZoomStep); }},
      {"Dark display", "d",
       [](Editor& e) { e.preview.dark = !e.preview.dark; }},
      {"Dark theme", "shift+d",
       [](Editor& e) { e.dark_theme = !e.dark_theme; }},
      {"Other layers", "shift+l",
       [](Editor& e) { e.shows_layers = !e.shows_layers; }},
      {"Black", "", [](Editor& e) { e.shows_black = !e.shows_black; }},
      {"Cells", "c", [](Editor& e) { e.preview.cells = !e.preview.cells; }},
  };
  for (const auto& [name, to] :
       {std::pair("Align left", "left"), std::pair("Align centres", "centre"),
        std::pair("Align right", "right"), std::pair("Align top", "top"),
        std::pair("Align middles", "middle"),
        std::pair("Align bottom", "bottom")}) {
    list.push_back(arranged(name, {{"do", "align_contours"}, {"to", to}}));
  }
  for (const auto& [name, along] : {std::pair("Distribute across", "x"),
                                    std::pair("Distribute upwards", "y")}) {
    list.push_back(
        arranged(name, {{"do", "distribute_contours"}, {"along", along}}));
  }
  for (const ToolInfo& tool : tool_list()) {
    const ToolKind kind = tool.kind;
    list.push_back(
        {tool.name, tool.key, [kind](Editor& e) { e.set_tool(kind); }});
  }
  struct Step {
    const char* keys[3];
    double x;
    double y;
  };
  static constexpr Step kSteps[] = {
      {{"left", "shift+left", "ctrl+left"}, -1, 0},
      {{"right", "shift+right", "ctrl+right"}, 1, 0},
      {{"up", "shift+up", "ctrl+up"}, 0, 1},
      {{"down", "shift+down", "ctrl+down"}, 0, -1},
  };
  for (const Step& step : kSteps) {
    double size = 1;
    for (const char* key : step.keys) {
      const double dx = size * step.x;
      const double dy = size * step.y;
      list.push_back({"Nudge", key, [dx, dy](Editor& e) { nudge(e, dx, dy); }});
      size *= 10;
    }
  }
  return list;
}

}  // namespace

const std::vector<Action>& action_list() {
  static const std::vector<Action> list = make_list();
  return list;
}

const Action& action(const std::string& name) {
  for (const Action& action : action_list()) {
    if (action.name == name) {
      return action;
    }
  }
  throw Error("action '" + name + "' is not known; the menus name them");
}

bool press_key(Editor& editor, const std::string& key) {
  if (editor.glyph() == nullptr) {
    return false;
  }
  for (const Action& action : action_list()) {
    std::istringstream keys(action.keys);
    for (std::string one; keys >> one;) {
      if (one == key) {
        action.run(editor);
        return true;
      }
    }
  }
  return false;
}

}  // namespace inkcell::design::editor
