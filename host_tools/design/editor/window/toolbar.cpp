// The strip of tools.
#include "editor/window/icons.hpp"
#include "editor/window/panels.hpp"

namespace inkcell::design::editor {
namespace {

constexpr float kButton = 34;
constexpr float kIcon = 18;

}  // namespace

void draw_toolbar(Panels& panels) {
  Editor& editor = panels.editor;
  const float side = px(kButton);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const ToolInfo& tool : tool_list()) {
    const bool is_chosen = tool.kind == editor.tool_kind();
    ImGui::SetCursorPosX((ImGui::GetWindowWidth() - side) / 2);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(tool.name, {side, side})) {
      editor.set_tool(tool.kind);
    }
    const ImVec2 end = {at.x + side, at.y + side};
    if (is_chosen || ImGui::IsItemHovered()) {
      list.AddRectFilled(at, end, is_chosen ? colour::tool : colour::raised,
                         px(5));
    }
    const float inset = (side - px(kIcon)) / 2;
    draw_icon(tool.kind, {at.x + inset, at.y + inset}, px(kIcon),
              is_chosen ? colour::paper : colour::ink);
    const std::string text = std::string(tool.name) + ". " + tool.hint;
    const std::string key(1, static_cast<char>(tool.key[0] - 'a' + 'A'));
    tooltip(text.c_str(), key.c_str());
  }
}

}  // namespace inkcell::design::editor
