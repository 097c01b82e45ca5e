// The parameters of a program in Lua as sliders.
#include "editor/lua_run.hpp"
#include "editor/window/panels.hpp"

namespace inkcell::design::editor {

void draw_lua(Panels& panels) {
  if (panels.lua.file.empty()) {
    return;
  }
  Editor& editor = panels.editor;
  bool is_open = true;
  bool is_shown = false;
  bool is_done = false;
  ImGui::SetNextWindowPos({px(310), px(60)}, ImGuiCond_Appearing);
  ImGui::Begin("Script", &is_open,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::TextDisabled("%s", panels.lua.file.filename().string().c_str());
  std::map<std::string, double> settings;
  for (ScriptParameter& each : panels.lua.parameters) {
    if (each.least < each.most) {
      is_shown |= ImGui::SliderScalar(each.name.c_str(), ImGuiDataType_Double,
                                      &each.value, &each.least, &each.most,
                                      "%.3g", ImGuiSliderFlags_AlwaysClamp);
    } else {
      ImGui::InputDouble(each.name.c_str(), &each.value);
      is_shown |= ImGui::IsItemDeactivatedAfterEdit();
    }
    is_done |= ImGui::IsItemDeactivatedAfterEdit();
    settings[each.name] = each.value;
  }
  const bool is_again = ImGui::Button("Run", {px(110), 0});
  tooltip("Reads the program again: what was changed in it counts");
  ImGui::End();
  if (is_shown || is_again) {
    attempt(editor, [&] {
      panels.lua = run_lua(editor.project(), panels.lua.file, settings);
      editor.propose(panels.lua.command);
    });
  }
  if (is_done || is_again) {
    attempt(editor, [&] { editor.commit(); });
  }
  if (!is_open) {
    panels.lua = {};
  }
}

}  // namespace inkcell::design::editor
