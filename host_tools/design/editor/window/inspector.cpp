// The properties of the selection, and the nib.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <cmath>

#include "editor/actions.hpp"
#include "editor/edits.hpp"
#include "editor/masters.hpp"
#include "editor/parts.hpp"
#include "editor/spacing.hpp"
#include "editor/strokes.hpp"
#include "editor/window/panels.hpp"
#include "model/bearings.hpp"
#include "shape/points.hpp"

namespace inkcell::design::editor {
namespace {

constexpr float kField = 96;

// A number that changes when the input field loses the focus.
bool number(const char* label, double& value) {
  ImGui::SetNextItemWidth(px(kField));
  ImGui::InputDouble(label, &value, 0, 0, "%.6g");
  return ImGui::IsItemDeactivatedAfterEdit();
}

void draw_advance(Editor& editor) {
  double width = editor.glyph()->width;
  if (number("Advance", width)) {
    attempt(editor, [&] {
      editor.run({{"do", "set_advance"}, {"width", width}});
    });
  }
}

void draw_bearings(Editor& editor) {
  std::optional<Bearings> now;
  attempt(editor,
          [&] { now = bearings_of(editor.shown_project(), *editor.glyph()); });
  if (!now) {
    return;
  }
  bool is_changed = number("Left", now->left);
  tooltip("The space left of the ink; glyphs with this part stay");
  ImGui::SameLine(0, px(18));
  is_changed |= number("Right", now->right);
  tooltip("The space right of the ink");
  if (is_changed) {
    attempt(editor, [&] {
      editor.run({{"do", "set_bearings"},
                  {"left", std::round(now->left)},
                  {"right", std::round(now->right)}});
    });
  }
}

// The kerning groups of the glyph, and what else is in them.
void draw_groups(Editor& editor) {
  for (const bool is_left : {true, false}) {
    std::string group =
        group_of(editor.project(), editor.glyph_name(), is_left);
    const std::string key =
        (is_left ? "public.kern1." : "public.kern2.") + group;
    ImGui::SetNextItemWidth(px(kField));
    ImGui::InputText(is_left ? "Group before others" : "Group after others",
                     &group);
    const bool is_changed = ImGui::IsItemDeactivatedAfterEdit();
    tooltip("Glyphs of a group are kerned alike; empty: no group");
    std::string members;
    for (const Value& member :
         editor.project().font->groups.value(key, Value::array())) {
      members += member.get<std::string>() + " ";
    }
    ImGui::TextDisabled("%s", members.c_str());
    if (is_changed) {
      attempt(editor, [&] {
        const Value command =
            join_group(editor.project(), editor.glyph_name(), is_left, group);
        if (!command.is_null()) {
          editor.run(command);
        }
      });
    }
  }
}

void draw_point(Editor& editor, PointId id) {
  const GlyphPoint point =
      editor.glyph()->contours[id.contour].points[id.point];
  double x = point.x;
  double y = point.y;
  bool is_changed = number("x", x);
  ImGui::SameLine(0, px(18));
  is_changed |= number("y", y);
  if (is_changed) {
    attempt(editor, [&] {
      editor.run(move_selection(*editor.glyph(), {id}, std::round(x - point.x),
                                std::round(y - point.y)));
    });
  }
  bool smooth = point.smooth;
  if (point.on_curve() && ImGui::Checkbox("Smooth", &smooth)) {
    attempt(editor, [&] { editor.run(toggle_smooth(*editor.glyph(), id)); });
  }
  tooltip("Handles on both sides stay in one line", "S");
}

void draw_guide(Editor& editor, size_t index) {
  const Guideline line = editor.glyph()->guidelines[index];
  Value command = {{"do", "set_guideline"}, {"guideline", index}};
  bool is_changed = false;
  const auto edit = [&](const char* label, std::optional<double> value) {
    if (value) {
      is_changed |= number(label, *value);
      command[label] = *value;
    }
  };
  edit("x", line.x);
  edit("y", line.y);
  edit("angle", line.angle);
  if (is_changed) {
    attempt(editor, [&] { editor.run(command); });
  }
}

void draw_knot(Editor& editor, PointId id) {
  const GlyphPointer glyph = editor.glyph();
  const Stroke stroke = strokes_of(*glyph)[id.contour];
  const StrokePoint& knot = stroke.points[id.point];
  Nib nib = nibs_of(stroke)[id.point];
  Point at = knot.at;
  double angle = std::round(nib.angle / gen::kDegree * 10) / 10;
  bool is_moved = number("x", at.x);
  ImGui::SameLine(0, px(18));
  is_moved |= number("y", at.y);
  bool is_changed = number("Width##knot", nib.width);
  ImGui::SameLine(0, px(18));
  is_changed |= number("Height##knot", nib.height);
  is_changed |= number("Angle##knot", angle);
  attempt(editor, [&] {
    if (is_moved) {
      editor.run(move_knots(*glyph, {id}, std::round(at.x - knot.at.x),
                            std::round(at.y - knot.at.y)));
    } else if (is_changed) {
      nib.angle = angle * gen::kDegree;
      editor.run(set_nib(*glyph, id, nib));
    }
  });
  bool is_smooth = !knot.is_corner;
  if (stroke.is_smooth && ImGui::Checkbox("Smooth##knot", &is_smooth)) {
    attempt(editor, [&] { editor.run(toggle_corner(*glyph, id)); });
  }
  tooltip("The centre line has no corner here", "S");
}

void draw_selection(Editor& editor) {
  if (editor.part) {
    ImGui::TextDisabled("Drag the part; arrows move it");
  } else if (editor.component) {
    const ComponentUse& use = editor.glyph()->components[*editor.component];
    ImGui::Text("Component %s", use.base.c_str());
    ImGui::TextDisabled("Moved by %g, %g", use.matrix.dx, use.matrix.dy);
  } else if (editor.guide) {
    draw_guide(editor, *editor.guide);
  } else if (editor.knots.size() == 1 && editor.selection.empty()) {
    draw_knot(editor, *editor.knots.begin());
  } else if (!editor.knots.empty()) {
    ImGui::Text("Selected knots: %zu, points: %zu", editor.knots.size(),
                editor.selection.size());
    ImGui::TextDisabled("Arrows move them by 1, Shift 10, Ctrl 100");
  } else if (editor.selection.empty() && has_strokes(*editor.glyph())) {
    ImGui::TextDisabled("No knot of a stroke is selected");
  } else if (editor.selection.empty()) {
    ImGui::TextDisabled("No point is selected");
  } else if (editor.selection.size() == 1) {
    draw_point(editor, *editor.selection.begin());
  } else {
    ImGui::Text("%zu points are selected", editor.selection.size());
    ImGui::TextDisabled("Arrows move them by 1, Shift 10, Ctrl 100");
    if (ImGui::Button("Align")) {
      attempt(editor, [&] { action("Align points").run(editor); });
    }
    tooltip("Gives them one height, or one x", "Ctrl+Shift+A");
  }
}

void draw_nib(NibSettings& nib) {
  int kind = nib.is_rectangle ? 1 : 0;
  ImGui::RadioButton("Ellipse", &kind, 0);
  ImGui::SameLine(0, px(18));
  ImGui::RadioButton("Rectangle##nib", &kind, 1);
  nib.is_rectangle = kind == 1;
  number("Width", nib.width);
  ImGui::SameLine(0, px(18));
  number("Height", nib.height);
  number("Angle", nib.angle);
}

void draw_components(Editor& editor) {
  const GlyphPointer glyph = editor.glyph();
  for (size_t i = 0; i < glyph->components.size(); ++i) {
    const std::string label =
        glyph->components[i].base + "##" + std::to_string(i);
    if (ImGui::Selectable(label.c_str(), editor.component == i,
                          ImGuiSelectableFlags_AllowDoubleClick)) {
      editor.component = i;
      editor.selection.clear();
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        attempt(editor, [&] { editor.show(glyph->components[i].base); });
        return;
      }
    }
    tooltip("A double click opens it");
  }
}

// The picture's lower left corner, and font units per pixel.
void draw_picture(Editor& editor) {
  const GlyphImage image = *editor.glyph()->image;
  Matrix m = image.matrix;
  const double before = std::hypot(m.xx, m.xy);
  double scale = before;
  ImGui::TextDisabled("Picture %s", image.file.c_str());
  bool is_changed = number("x##picture", m.dx);
  ImGui::SameLine(0, px(18));
  is_changed |= number("y##picture", m.dy);
  is_changed |= number("Scale", scale);
  tooltip("Font units that a pixel is wide");
  if (!is_changed) {
    return;
  }
  if (scale > 0 && before > 0) {
    for (double* entry : {&m.xx, &m.xy, &m.yx, &m.yy}) {
      *entry *= scale / before;
    }
  }
  attempt(editor, [&] {
    editor.run({{"do", "set_image"},
                {"file", image.file},
                {"matrix", {m.xx, m.xy, m.yx, m.yy, m.dx, m.dy}},
                {"color", image.color}});
  });
}

// The master that is edited, what does not correspond in the other one, and how
// far the preview goes towards that.
void draw_masters(Editor& editor) {
  const Project& project = editor.project();
  const size_t shown = editor.master();
  ImGui::TextDisabled("Master");
  ImGui::SetNextItemWidth(px(kField));
  if (ImGui::BeginCombo("##master", master_name(project, shown).c_str())) {
    for (size_t i = 0; i < project.layers.size(); ++i) {
      if (project.find(editor.glyph_name(), i) != nullptr &&
          ImGui::Selectable(master_name(project, i).c_str(), i == shown)) {
        editor.choose_master(i);
      }
    }
    ImGui::EndCombo();
  }
  const auto other = other_master(editor);
  if (!other) {
    return;
  }
  const std::string name = master_name(project, *other);
  const std::vector<std::string> wrong = mismatches(
      *editor.glyph(), *project.find(editor.glyph_name(), *other), name);
  if (wrong.empty()) {
    ImGui::SameLine(0, px(18));
    auto part = static_cast<float>(100 * editor.part_between);
    ImGui::SetNextItemWidth(-1);
    if (ImGui::SliderFloat("##between", &part, 0, 100,
                           ("%.0f %% to " + name).c_str(),
                           ImGuiSliderFlags_AlwaysClamp)) {
      editor.part_between = static_cast<double>(part) / 100;
    }
    tooltip("Shows a glyph between the masters");
    return;
  }
  ImGui::PushStyleColor(ImGuiCol_Text, colour::corner);
  constexpr size_t kMost = 3;
  for (size_t i = 0; i < wrong.size() && i < kMost; ++i) {
    ImGui::TextWrapped("%s", wrong[i].c_str());
  }
  if (wrong.size() > kMost) {
    ImGui::TextWrapped("... and %zu more", wrong.size() - kMost);
  }
  ImGui::PopStyleColor();
}

}  // namespace

void draw_inspector(Panels& panels) {
  Editor& editor = panels.editor;
  if (editor.glyph() == nullptr) {
    return;
  }
  ImGui::TextDisabled("Glyph");
  draw_advance(editor);
  draw_bearings(editor);
  if (editor.project().layers.size() > 1 &&
      (editor.shows_layers || editor.master() != 0)) {
    draw_masters(editor);
  }
  if (editor.tool_kind() == ToolKind::spacing) {
    ImGui::Separator();
    ImGui::TextDisabled("Kerning groups");
    draw_groups(editor);
    return;
  }
  if (!editor.glyph()->components.empty()) {
    ImGui::TextDisabled("Components");
    draw_components(editor);
  }
  if (has_tree(*editor.glyph())) {
    ImGui::TextDisabled("Made of");
    draw_tree(editor);
  }
  if (editor.glyph()->image) {
    draw_picture(editor);
  }
  ImGui::Separator();
  ImGui::TextDisabled("Selection");
  draw_selection(editor);
  if (editor.tool_kind() == ToolKind::stroke) {
    ImGui::Separator();
    ImGui::TextDisabled("Nib");
    draw_nib(editor.nib);
  }
}

}  // namespace inkcell::design::editor
