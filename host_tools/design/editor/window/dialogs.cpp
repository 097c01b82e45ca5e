// Dialogs that ask for a file or a name.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

#include "editor/glyph_set.hpp"
#include "editor/parts.hpp"
#include "editor/window/panels.hpp"
#include "import/image_import.hpp"
#include "model/error.hpp"

namespace inkcell::design::editor {
namespace {

namespace fs = std::filesystem;

constexpr const char* kQuestion = "Quit";
constexpr const char* kComponent = "Add component";

using Values = std::vector<std::string>;

struct Dialog {
  const char* name;
  const char* text;
  const char* button;
  std::vector<std::string> endings;  // of the files that are listed
  std::vector<const char*> labels;   // of values after the first
  Values (*propose)(const Editor& editor);
  void (*run)(Panels& panels, const Values& values);
};

Values nothing(const Editor&) {
  return {""};
}

double number_of(const std::string& label, const std::string& text) {
  try {
    return std::stod(text);
  } catch (const std::exception&) {
    throw Error(label + " is '" + text + "', which is no number");
  }
}

void make_font(Panels& panels, const Values& values) {
  if (values[1].empty()) {
    throw Error("Name is empty: a font has one");
  }
  panels.editor.create(values[0],
                       {{"familyName", values[1]},
                        {"styleName", "Regular"},
                        {"unitsPerEm", number_of("Units an em", values[2])},
                        {"ascender", number_of("Ascender", values[3])},
                        {"descender", number_of("Descender", values[4])},
                        {"xHeight", number_of("x-height", values[5])},
                        {"capHeight", number_of("Cap height", values[6])}},
                       values[7]);
}

// Names, each with its place: "Semi Bold 600 Bold 700".
std::vector<std::pair<std::string, double>> places_of(const std::string& text) {
  std::vector<std::pair<std::string, double>> places;
  std::istringstream words(text);
  std::string name;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    const double at = std::strtod(word.c_str(), &end);
    if (*end == '\0' && !name.empty()) {
      places.emplace_back(name, at);
      name.clear();
    } else {
      name += (name.empty() ? "" : " ") + word;
    }
  }
  if (!name.empty()) {
    throw Error("'" + name + "' has no number behind it");
  }
  return places;
}

// One axis, from the default master on.
void set_axis(Panels& panels, const Values& values) {
  Editor& editor = panels.editor;
  const std::string tag = values[0].substr(0, 4);
  const std::string name = values[0].size() > 5 ? values[0].substr(5) : "";
  Value command = {{"do", "set_axes"}, {"instances", Value::array()}};
  command["axes"] = Value::array({Value{{"tag", tag}, {"name", name}}});
  command["masters"][editor.project().front().name][tag] =
      number_of("Default", values[1]);
  for (const auto& [master, at] : places_of(values[2])) {
    command["masters"][master][tag] = at;
  }
  for (const auto& [instance, at] : places_of(values[3])) {
    command["instances"].push_back({{"name", instance}, {tag, at}});
  }
  editor.run(command);
}

const std::vector<Dialog>& dialog_list() {
  static const std::vector<Dialog> list = {
      {"Open",
       "A project (UFO), or a font (TTF, OTF) to make one of",
       "Open",
       {".ufo", ".ttf", ".otf"},
       {},
       nothing,
       [](Panels& panels, const Values& values) {
         panels.editor.open(values[0]);
       }},
      {"New font",
       "A project (UFO) with empty glyphs: characters (Hano2!) or ranges "
       "(A-Z,U+B0)",
       "Make",
       {".ufo"},
       {"Name", "Units an em", "Ascender", "Descender", "x-height",
        "Cap height", "Glyphs"},
       [](const Editor&) {
         return Values{"Untitled.ufo", "Untitled", "1000", "800",
                       "-200",         "500",      "700",  "0x20-0x7E"};
       },
       make_font},
      {"Save as",
       "Another project (UFO); this one stays as it was saved last",
       "Save",
       {".ufo"},
       {},
       [](const Editor&) { return Values{"Copy.ufo"}; },
       [](Panels& panels, const Values& values) {
         panels.editor.save_as(values[0]);
       }},
      {"Export",
       "A font (.ttf, .bin), a copy of the project (.ufo), or the sources of "
       "a variable font (.designspace)",
       "Export",
       {".ttf", ".bin", ".ufo"},
       {},
       [](const Editor& editor) {
         std::string name =
             editor.project().font->info.value("familyName", "Font");
         name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
         return Values{(name.empty() ? "Font" : name) + ".ttf"};
       },
       [](Panels& panels, const Values& values) {
         panels.editor.export_to(values[0]);
       }},
      {"Add glyphs",
       "Characters (Hano2!), ranges (A-Z,U+B0), or a name (exclam, _stem)",
       "Add",
       {},
       {},
       nothing,
       [](Panels& panels, const Values& values) {
         Editor& editor = panels.editor;
         const size_t before = editor.project().front().glyphs.size();
         editor.run(add_glyphs(editor.project(), values[0]));
         const size_t added = editor.project().front().glyphs.size() - before;
         editor.message = {"Added glyphs: " + std::to_string(added)};
       }},
      {"Name and characters",
       "The glyph's name, and its characters (U+0041,U+0391)",
       "Change",
       {},
       {"Characters"},
       [](const Editor& editor) {
         return Values{editor.glyph_name(), character_list(*editor.glyph())};
       },
       [](Panels& panels, const Values& values) {
         Editor& editor = panels.editor;
         editor.run(set_characters(values[1]));
         if (values[0] != editor.glyph_name()) {
           editor.run(rename_to(values[0]));
         }
       }},
      {"Add master",
       "A layer with the same glyphs, such as Bold; the project is saved, and "
       "its steps to undo go",
       "Add",
       {},
       {"Stems wider by"},
       [](const Editor&) {
         return Values{"Bold", "0"};
       },
       [](Panels& panels, const Values& values) {
         panels.editor.add_master(values[0],
                                  number_of("Stems wider by", values[1]));
       }},
      {"Axis and instances",
       "The axis of a variable font: wght Weight; export it as .designspace",
       "Set",
       {},
       {"Default master at", "Other masters, each with its place", "Instances"},
       [](const Editor& editor) {
         Values values = {"wght Weight", "400", "", "Medium 500"};
         int place = 400;
         for (size_t i = 1; i < editor.project().layers.size(); ++i) {
           values[2] += (i == 1 ? "" : " ") + editor.project().layers[i].name +
                        " " + std::to_string(place += 300);
         }
         return values;
       },
       set_axis},
      {"Remove master",
       "Its outlines, the axes and the steps to undo go; the project is saved",
       "Remove",
       {},
       {},
       [](const Editor& editor) {
         return Values{editor.project().layers.back().name};
       },
       [](Panels& panels, const Values& values) {
         panels.editor.remove_master(values[0]);
       }},
      {kComponent,
       "The glyph to put into this one: a click, or its name or character",
       "Add",
       {},
       {},
       nothing,
       [](Panels& panels, const Values& values) {
         Editor& editor = panels.editor;
         const std::vector<std::string> found =
             found_glyphs(editor.project(), values[0], true);
         const std::string base =
             values[0].empty() || found.empty() ? values[0] : found.front();
         editor.run(has_tree(*editor.glyph())
                        ? add_part(*editor.glyph(), base)
                        : Value{{"do", "add_component"}, {"base", base}});
       }},
      {kScript,
       "A program in Lua; its parameters become sliders",
       "Run",
       {".lua"},
       {},
       nothing,
       [](Panels& panels, const Values& values) {
         panels.lua = run_lua(panels.editor.project(), values[0], {});
         panels.editor.run(panels.lua.command);
       }},
      {"Background picture",
       "A picture (PNG) behind the outline; the project keeps a copy",
       "Show",
       {".png"},
       {},
       nothing,
       [](Panels& panels, const Values& values) {
         panels.editor.run(image_command(panels.editor.project(), values[0]));
       }},
  };
  return list;
}

// Begins a dialog that takes all input. Returns whether it is shown, as
// BeginPopupModal().
bool begin_modal(const char* name) {
  ImGui::OpenPopup(name);
  return ImGui::BeginPopupModal(name, nullptr,
                                ImGuiWindowFlags_AlwaysAutoResize);
}

bool is_pressed(ImGuiKey key) {
  return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

void draw_wrapped(const std::string& text) {
  ImGui::PushTextWrapPos(px(520));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
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
  const float height = std::min(px(260), 0.3f * ImGui::GetIO().DisplaySize.y);
  ImGui::BeginChild("files", {px(520), height}, true);
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
  bool is_entered = ImGui::InputText(
      "##path", &panels.dialog_values[0],
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (!dialog.endings.empty()) {
    draw_files(dialog, panels.dialog_values[0]);
  }
  if (panels.dialog == kComponent) {
    const std::string clicked = draw_picker(panels, panels.dialog_values[0]);
    if (!clicked.empty()) {
      panels.dialog_values[0] = clicked;
      is_entered = true;
    }
  }
  for (size_t i = 0; i < dialog.labels.size(); ++i) {
    ImGui::SetNextItemWidth(px(260));
    is_entered |=
        ImGui::InputText(dialog.labels[i], &panels.dialog_values[i + 1],
                         ImGuiInputTextFlags_EnterReturnsTrue);
  }
  if (!panels.dialog_problem.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour::corner);
    draw_wrapped(panels.dialog_problem);
    ImGui::PopStyleColor();
  }
  if (ImGui::Button(dialog.button, {px(110), 0}) || is_entered) {
    try {
      dialog.run(panels, panels.dialog_values);
      panels.dialog.clear();
      ImGui::CloseCurrentPopup();
    } catch (const std::exception& error) {
      panels.dialog_problem = error.what();  // stays open
    }
  }
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {px(110), 0}) || is_pressed(ImGuiKey_Escape)) {
    panels.dialog.clear();
    ImGui::CloseCurrentPopup();
  }
}

// The question before the program ends.
void draw_question(Panels& panels) {
  Editor& editor = panels.editor;
  if (!begin_modal(kQuestion)) {
    return;
  }
  ImGui::Text("%s has changes that are not saved.",
              editor.session().files().folder.filename().string().c_str());
  const auto button = [&panels](const char* label, const char* hint) {
    const bool is_chosen = ImGui::Button(label, {px(110), 0});
    tooltip(hint);
    ImGui::SameLine();
    if (is_chosen) {
      panels.dialog.clear();
      ImGui::CloseCurrentPopup();
    }
    return is_chosen;
  };
  if (button("Save", "Saves the project and quits")) {
    attempt(editor, [&] {
      editor.save();
      panels.wants_quit = true;
    });
  }
  if (button("Discard", "Quits; the project is as it was saved last")) {
    attempt(editor, [&] { editor.discard(); });
    panels.wants_quit = true;
  }
  if (button("Keep", "Quits; the changes are there when it is opened again")) {
    panels.wants_quit = true;
  }
  if (button("Cancel", "Goes back") || is_pressed(ImGuiKey_Escape)) {
    panels.dialog.clear();
  }
  ImGui::EndPopup();
}

// The question before a glyph loses its strokes or parts.
void draw_outline_question(Editor& editor) {
  if (!begin_modal("Turn into an outline?")) {
    return;
  }
  ImGui::TextUnformatted(
      "The glyph is made of strokes or parts. This changes its points:\n"
      "it would no longer follow them. Undo brings them back.");
  const bool is_wanted = ImGui::Button("Turn into outline", {px(150), 0});
  ImGui::SameLine();
  if (is_wanted) {
    attempt(editor, [&] { editor.make_outline(); });
  } else if (ImGui::Button("Cancel", {px(110), 0}) ||
             is_pressed(ImGuiKey_Escape)) {
    editor.pending.reset();
  }
  if (!editor.pending) {
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void draw_imported(Editor& editor) {
  if (!begin_modal("Imported")) {
    return;
  }
  draw_wrapped(editor.message.text + editor.imported);
  if (ImGui::Button("OK", {px(110), 0}) || is_pressed(ImGuiKey_Enter) ||
      is_pressed(ImGuiKey_Escape)) {
    editor.imported.clear();
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

}  // namespace

void draw_apply_or_cancel(Panels& panels) {
  Editor& editor = panels.editor;
  const bool is_applied = ImGui::Button("Apply", {px(110), 0});
  ImGui::SameLine();
  if (is_applied) {
    attempt(editor, [&] { editor.commit(); });
  } else if (!ImGui::Button("Cancel", {px(110), 0}) &&
             (ImGui::IsAnyItemActive() || !is_pressed(ImGuiKey_Escape))) {
    return;
  }
  editor.propose(nullptr);
  panels.dialog.clear();
}

void open_dialog(Panels& panels, const char* name) {
  if (name == std::string(kTransform) || name == std::string(kWeight)) {
    panels.dialog = name;
    panels.transform = {};
    panels.weight = {};
  }
  for (const Dialog& dialog : dialog_list()) {
    if (std::string(dialog.name) == name) {
      panels.dialog = name;
      panels.dialog_values = dialog.propose(panels.editor);
      panels.dialog_problem.clear();
    }
  }
}

void quit(Panels& panels) {
  if (panels.editor.is_open() && panels.editor.session().has_changes()) {
    panels.dialog = kQuestion;
  } else {
    panels.wants_quit = true;
  }
}

void draw_dialogs(Panels& panels) {
  if (panels.editor.pending) {
    draw_outline_question(panels.editor);
    return;
  }
  if (!panels.editor.imported.empty()) {
    draw_imported(panels.editor);
    return;
  }
  for (const auto& [name, draw] : {std::pair(kQuestion, &draw_question),
                                   {kTransform, &draw_transform},
                                   {kWeight, &draw_weight}}) {
    if (panels.dialog == name) {
      draw(panels);
      return;
    }
  }
  for (const Dialog& dialog : dialog_list()) {
    if (panels.dialog != dialog.name) {
      continue;
    }
    if (begin_modal(dialog.name)) {
      draw_dialog(panels, dialog);
      ImGui::EndPopup();
      return;
    }
  }
}

}  // namespace inkcell::design::editor
