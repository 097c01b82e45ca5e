// Dialogs that ask for a file or a name.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "editor/window/panels.hpp"
#include "import/image_import.hpp"

namespace inkcell::design::editor {
namespace {

namespace fs = std::filesystem;

struct Dialog {
  const char* name;
  const char* text;
  const char* button;
  std::vector<std::string> endings;  // of the files that are listed
  void (*run)(Editor& editor, const std::string& value);
};

const std::vector<Dialog>& dialog_list() {
  static const std::vector<Dialog> list = {
      {"Open",
       "A project (UFO), or a font (TTF, OTF) to make one of",
       "Open",
       {".ufo", ".ttf", ".otf"},
       [](Editor& editor, const std::string& value) { editor.open(value); }},
      {"Export",
       "A font (.ttf, .bin) or a copy of the project (.ufo)",
       "Export",
       {".ttf", ".bin", ".ufo"},
       [](Editor& editor, const std::string& value) {
         editor.export_to(value);
         editor.message = {"Wrote " + value};
       }},
      {"Add component",
       "The name of the glyph to put into this one",
       "Add",
       {},
       [](Editor& editor, const std::string& value) {
         editor.run({{"do", "add_component"}, {"base", value}});
       }},
      {"Background picture",
       "A picture (PNG) behind the outline; the project keeps a copy",
       "Show",
       {".png"},
       [](Editor& editor, const std::string& value) {
         editor.run(image_command(editor.project(), value));
       }},
  };
  return list;
}

bool has_ending(const fs::path& path, const Dialog& dialog) {
  return std::find(dialog.endings.begin(), dialog.endings.end(),
                   path.extension().string()) != dialog.endings.end();
}

// Folders and files that match the typed path; a click completes it.
void draw_files(const Dialog& dialog, std::string& path) {
  const fs::path typed(path);
  fs::path folder = typed.has_parent_path() ? typed.parent_path() : ".";
  std::error_code error;
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const bool is_hidden = entry.path().filename().string()[0] == '.';
    if (!is_hidden &&
        (has_ending(entry.path(), dialog) || entry.is_directory(error))) {
      entries.push_back(entry.path());
    }
  }
  std::sort(entries.begin(), entries.end());
  ImGui::BeginChild("files", {px(520), px(260)}, true);
  if (ImGui::Selectable("..", false, ImGuiSelectableFlags_DontClosePopups)) {
    path =
        (fs::absolute(folder).lexically_normal().parent_path() / "").string();
  }
  for (const fs::path& entry : entries) {
    const bool is_folder =
        fs::is_directory(entry, error) && !has_ending(entry, dialog);
    const std::string label =
        entry.filename().string() + (is_folder ? "/" : "");
    if (ImGui::Selectable(label.c_str(), false,
                          ImGuiSelectableFlags_DontClosePopups)) {
      path = is_folder ? (entry / "").string() : entry.string();
    }
  }
  ImGui::EndChild();
}

void draw_dialog(Panels& panels, const Dialog& dialog) {
  ImGui::TextDisabled("%s", dialog.text);
  if (ImGui::IsWindowAppearing()) {
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(px(520));
  const bool is_entered = ImGui::InputText(
      "##path", &panels.dialog_path,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (!dialog.endings.empty()) {
    draw_files(dialog, panels.dialog_path);
  }
  if (ImGui::Button(dialog.button, {px(110), 0}) || is_entered) {
    attempt(panels.editor,
            [&] { dialog.run(panels.editor, panels.dialog_path); });
    panels.dialog.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {px(110), 0}) ||
      ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
    panels.dialog.clear();
    ImGui::CloseCurrentPopup();
  }
}

}  // namespace

void draw_dialogs(Panels& panels) {
  for (const Dialog& dialog : dialog_list()) {
    if (panels.dialog != dialog.name) {
      continue;
    }
    ImGui::OpenPopup(dialog.name);
    if (ImGui::BeginPopupModal(dialog.name, nullptr,
                               ImGuiWindowFlags_AlwaysAutoResize)) {
      draw_dialog(panels, dialog);
      ImGui::EndPopup();
      return;
    }
  }
}

}  // namespace inkcell::design::editor
