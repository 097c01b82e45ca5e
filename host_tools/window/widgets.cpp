#include "window/widgets.hpp"

#include "window/theme.hpp"

namespace inkcell::tools {
namespace {

constexpr float kTooltipWidth = 280;

constexpr ImGuiWindowFlags kFixed =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
    ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings;

}  // namespace

void tooltip(const char* text, const char* keys) {
  if (!ImGui::IsItemHovered()) {
    return;
  }
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(kTooltipWidth));
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  if (*keys != '\0') {
    ImGui::TextDisabled("%s", keys);
  }
  ImGui::EndTooltip();
}

bool choice(const char* label, bool is_chosen, const char* hint) {
  if (is_chosen) {
    ImGui::PushStyleColor(ImGuiCol_Button, colour::tool);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colour::tool);
    ImGui::PushStyleColor(ImGuiCol_Text, colour::paper);
  }
  const bool is_pressed = ImGui::Button(label);
  if (is_chosen) {
    ImGui::PopStyleColor(3);
  }
  tooltip(hint);
  return is_pressed;
}

void panel(const char* name,
           ImVec2 at,
           ImVec2 size,
           const std::function<void()>& draw,
           ImGuiWindowFlags flags) {
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize(size);
  if (ImGui::Begin(name, nullptr, kFixed | flags)) {
    draw();
  }
  ImGui::End();
}

}  // namespace inkcell::tools
