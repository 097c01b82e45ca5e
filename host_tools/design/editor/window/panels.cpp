#include "editor/window/panels.hpp"

#include <algorithm>
#include <cmath>

namespace inkcell::design::editor {
namespace {

constexpr float kToolbarWidth = 52;
constexpr float kStatusHeight = 30;

// The side of a panel: a share of the window's, so that small windows keep room
// for the canvas.
struct PanelSide {
  float share;
  float least;
  float most;

  float of(float window) const {
    return std::clamp(std::round(share * window), px(least), px(most));
  }
};

constexpr PanelSide kGridWidth = {0.165f, 132, 232};
constexpr PanelSide kSideWidth = {0.26f, 318, 372};
constexpr PanelSide kInspectorHeight = {0.38f, 160, 292};

void draw_message(const Message& message) {
  ImGui::PushStyleColor(ImGuiCol_Text,
                        message.is_problem ? colour::corner : colour::faint);
  ImGui::TextUnformatted(message.text.c_str());
  ImGui::PopStyleColor();
  tooltip(message.text.c_str());
}

}  // namespace

void draw_window(Panels& panels) {
  if (panels.dark_theme != panels.editor.dark_theme) {
    panels.dark_theme = panels.editor.dark_theme;
    tools::set_dark(panels.dark_theme);
  }
  draw_menu(panels);
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const float top = ImGui::GetFrameHeight();
  const float bottom = all.y - px(kStatusHeight);
  const float middle = bottom - top;
  const float side = kSideWidth.of(all.x);
  const float tools = px(kToolbarWidth);
  const float grid = kGridWidth.of(all.x);
  const float inspector = kInspectorHeight.of(middle);
  panel(
      "Tools", {0, top}, {tools, middle}, [&] { draw_toolbar(panels); },
      ImGuiWindowFlags_NoScrollbar);
  panel(
      "Glyphs", {tools, top}, {grid, middle}, [&] { draw_glyph_grid(panels); },
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  panel(
      "Canvas", {tools + grid, top}, {all.x - tools - grid - side, middle},
      [&] { draw_canvas(panels); },
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  panel("Preview", {all.x - side, top}, {side, middle - inspector},
        [&] { draw_preview_panel(panels); });
  panel("Inspector", {all.x - side, bottom - inspector}, {side, inspector},
        [&] { draw_inspector(panels); });
  panel(
      "Status", {0, bottom}, {all.x, px(kStatusHeight)},
      [&] { draw_status(panels); }, ImGuiWindowFlags_NoScrollbar);
  draw_lua(panels);
  draw_dialogs(panels);
}

void draw_status(Panels& panels) {
  const Editor& editor = panels.editor;
  ImGui::SetCursorPosY(px(6));
  if (editor.glyph() == nullptr) {
    draw_message(
        editor.message.text.empty()
            ? Message{"Open a TTF, OTF or UFO: Ctrl+O; new font: Ctrl+N"}
            : editor.message);
    return;
  }
  ImGui::TextUnformatted(editor.session().has_changes() ? "Changed" : "Saved");
  tooltip("Every change is in the project's journal at once");
  ImGui::SameLine(0, px(18));
  draw_message(editor.message);
  const char* hint = "";
  for (const ToolInfo& tool : tool_list()) {
    hint = tool.kind == editor.tool_kind() ? tool.hint : hint;
  }
  if (editor.tool_kind() == ToolKind::select && is_undrawn(*editor.glyph())) {
    hint = "Empty: draw with P pen, R rectangle, O ellipse or B stroke";
  }
  const float at =
      ImGui::GetWindowWidth() - ImGui::CalcTextSize(hint).x - px(14);
  if (ImGui::GetItemRectMax().x + px(18) < at) {  // the message comes first
    ImGui::SameLine(at);
    ImGui::TextDisabled("%s", hint);
  }
}

}  // namespace inkcell::design::editor
