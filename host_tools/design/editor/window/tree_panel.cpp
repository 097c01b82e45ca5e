// The operators and parts of a glyph that is made of others.
#include <algorithm>

#include "editor/parts.hpp"
#include "editor/window/panels.hpp"
#include "model/sources.hpp"

namespace inkcell::design::editor {
namespace {

constexpr const char* kOperators[] = {"union", "difference", "intersection",
                                      "exclusion", "blend"};
constexpr const char* kLabels[] = {"Union", "Subtraction", "Intersection",
                                   "Exclusion", "Blend"};
constexpr double kRadius = 0.06;  // of a new blend [em]

// What a panel asks of the editor after its widgets are drawn.
struct TreeEdit {
  bool is_shown = false;  // while a slider moves
  bool is_done = false;
  std::string opened;  // a part to edit
};

void draw_operator(const Editor& editor, Value& node, TreeEdit& edit) {
  const double em = editor.project().units_per_em();
  int chosen = 0;
  for (int i = 0; i < 5; ++i) {
    chosen = node["op"] == kOperators[i] ? i : chosen;
  }
  ImGui::SetNextItemWidth(px(110));
  if (ImGui::Combo("##op", &chosen, kLabels, 5)) {
    node["op"] = kOperators[chosen];
    if (chosen == 4 && !node.contains("radius")) {
      node["radius"] = std::round(kRadius * em);
    }
    edit.is_shown = edit.is_done = true;
  }
  if (node["op"] != "blend") {
    return;
  }
  ImGui::SameLine();
  auto radius = static_cast<float>(node.value("radius", 1.0));
  ImGui::SetNextItemWidth(px(150));
  if (ImGui::SliderFloat("Radius", &radius, 1, static_cast<float>(em / 4),
                         "%.0f")) {
    node["radius"] = std::max(1.0, std::round(static_cast<double>(radius)));
    edit.is_shown = true;
  }
  edit.is_done |= ImGui::IsItemDeactivatedAfterEdit();
}

void draw_node(Editor& editor, Value& node, size_t& number, TreeEdit& edit) {
  if (node.contains("glyph")) {
    ImGui::PushID(static_cast<int>(number));
    const std::string name = node["glyph"].get<std::string>();
    if (ImGui::Selectable(name.c_str(), editor.part == number,
                          ImGuiSelectableFlags_AllowDoubleClick)) {
      editor.select_nothing();
      editor.part = number;
      if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        edit.opened = name;
      }
    }
    tooltip("A double click opens the part");
    ImGui::PopID();
    ++number;
    return;
  }
  ImGui::PushID(static_cast<int>(1000 + number));
  draw_operator(editor, node, edit);
  ImGui::Indent(px(12));
  for (Value& part : node["parts"]) {
    draw_node(editor, part, number, edit);
  }
  ImGui::Unindent(px(12));
  ImGui::PopID();
}

}  // namespace

void draw_tree(Editor& editor) {
  const GlyphPointer glyph = editor.glyph();
  Value tree = glyph->lib[kTreeKey];
  TreeEdit edit;
  size_t number = 0;
  attempt(editor, [&] {
    draw_node(editor, tree, number, edit);
    if (edit.is_shown) {
      editor.propose(set_tree(tree));
    }
    if (edit.is_done) {
      editor.commit();
    }
    if (!edit.opened.empty()) {
      editor.show(edit.opened);
    }
  });
}

}  // namespace inkcell::design::editor
