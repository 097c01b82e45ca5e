// The menu bar.
#include "editor/actions.hpp"
#include "editor/window/panels.hpp"

namespace inkcell::design::editor {
namespace {

// "Ctrl+Z" for the first of "ctrl+z ctrl+y".
std::string shown_keys(const char* keys) {
  std::string text(keys);
  text = text.substr(0, text.find(' '));
  bool is_first = true;
  for (char& c : text) {
    if (is_first && c >= 'a' && c <= 'z') {
      c = static_cast<char>(c - 'a' + 'A');
    }
    is_first = c == '+';
  }
  return text;
}

// A menu item for an action, or a separator.
void item(Panels& panels, const char* name, bool is_chosen = false) {
  if (*name == '\0') {
    ImGui::Separator();
    return;
  }
  const Action& known = action(name);
  if (ImGui::MenuItem(name, shown_keys(known.keys).c_str(), is_chosen,
                      panels.editor.glyph() != nullptr)) {
    attempt(panels.editor, [&] { known.run(panels.editor); });
  }
}

void dialog_item(Panels& panels,
                 const char* name,
                 const char* keys,
                 bool is_possible) {
  if (ImGui::MenuItem(name, keys, false, is_possible)) {
    open_dialog(panels, name);
  }
}

// The steps since the project was opened; a click goes to the state after one.
void draw_history(Panels& panels) {
  Editor& editor = panels.editor;
  if (!ImGui::BeginMenu("History", editor.is_open())) {
    return;
  }
  const std::vector<Step>& steps = editor.session().history();
  const size_t done = editor.session().done();
  constexpr size_t kMost = 30;
  for (size_t i = steps.size() + 1; i-- > 0 && i + kMost > steps.size();) {
    const std::string title =
        (i == 0 ? "Opened" : steps[i - 1].title) + "##" + std::to_string(i);
    if (ImGui::MenuItem(title.c_str(), "", i == done)) {
      attempt(editor, [&] { editor.go_to(i); });
      break;
    }
  }
  ImGui::EndMenu();
}

}  // namespace

void draw_menu(Panels& panels) {
  if (!ImGui::BeginMainMenuBar()) {
    return;
  }
  const bool is_open = panels.editor.is_open();
  if (ImGui::BeginMenu("File")) {
    dialog_item(panels, "New font", "Ctrl+N", true);
    dialog_item(panels, "Open", "Ctrl+O", true);
    if (ImGui::MenuItem("Open the sample")) {
      attempt(panels.editor, [&] { panels.editor.open_sample(); });
    }
    item(panels, "Save");
    dialog_item(panels, "Save as", "Ctrl+Shift+S", is_open);
    item(panels, "Revert");
    dialog_item(panels, "Export", "Ctrl+E", is_open);
    dialog_item(panels, "Add master", "", is_open);
    dialog_item(panels, "Axis and instances", "", is_open);
    dialog_item(panels, "Remove master", "", is_open);
    dialog_item(panels, kScript, "", is_open);
    ImGui::Separator();
    if (ImGui::MenuItem("Quit", "Ctrl+Q")) {
      quit(panels);
    }
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Edit")) {
    for (const char* name :
         {"Undo", "Redo", "Undo in this glyph", "Redo in this glyph"}) {
      item(panels, name);
    }
    draw_history(panels);
    for (const char* name : {"", "Cut", "Copy", "Paste", "Duplicate", "Delete",
                             "", "Select all", "Select none"}) {
      item(panels, name);
    }
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Glyph")) {
    for (const char* name :
         {"Unite", "Subtract", "Intersect", "Exclude", "", "Smooth or corner",
          "Reverse contours", "Round to whole units", "Convert to cubics",
          "Curves from the field", "Decompose", "Combine components",
          "Turn into outline", "Space letters", "", "Next glyph",
          "Previous glyph"}) {
      item(panels, name);
    }
    ImGui::Separator();
    dialog_item(panels, "Add glyphs", "Ctrl+Shift+N", is_open);
    dialog_item(panels, "Name and characters", "",
                panels.editor.glyph() != nullptr);
    item(panels, "Delete glyph");
    ImGui::Separator();
    dialog_item(panels, "Add component", "Ctrl+Shift+C", is_open);
    dialog_item(panels, "Background picture", "", is_open);
    item(panels, "Remove picture");
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("Transform")) {
    dialog_item(panels, kTransform, "", panels.editor.glyph() != nullptr);
    dialog_item(panels, kWeight, "", panels.editor.glyph() != nullptr);
    for (const char* name :
         {"Reflect left and right", "Reflect up and down", "Turn left",
          "Turn right", "", "Align points", "Align left", "Align centres",
          "Align right", "Align top", "Align middles", "Align bottom", "",
          "Distribute across", "Distribute upwards"}) {
      item(panels, name);
    }
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu("View")) {
    for (const char* name : {"Fit glyph", "Zoom in", "Zoom out"}) {
      item(panels, name);
    }
    ImGui::Separator();
    item(panels, "Horizontal guide");
    item(panels, "Vertical guide");
    item(panels, "Other layers", panels.editor.shows_layers);
    ImGui::Separator();
    item(panels, "Black", panels.editor.shows_black);
    item(panels, "Cells", panels.editor.preview.cells);
    item(panels, "Dark display", panels.editor.preview.dark);
    item(panels, "Dark theme", panels.editor.dark_theme);
    ImGui::EndMenu();
  }
  ImGui::EndMainMenuBar();
}

}  // namespace inkcell::design::editor
