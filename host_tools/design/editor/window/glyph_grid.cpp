// All glyphs of the font.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/glyph_set.hpp"
#include "editor/thumbnail.hpp"
#include "editor/window/panels.hpp"
#include "rom_file.hpp"

namespace inkcell::design::editor {
namespace {

constexpr float kCell = 46;
constexpr float kLabel = 15;
constexpr float kGap = 3;
constexpr size_t kLetters = 7;  // ".notdef"

// The label of a glyph: its character, or the start of its name.
std::string label_of(const Glyph& glyph) {
  if (!glyph.unicodes.empty() && glyph.unicodes[0] > U' ' &&
      glyph.unicodes[0] < 0x2000) {
    return tools::to_utf8(glyph.unicodes[0]);
  }
  return glyph.name.substr(0, kLetters);
}

// Whether the text is a glyph's character, or its name.
bool is_exact(const Glyph& glyph, const std::string& text) {
  return glyph.name == text ||
         std::any_of(glyph.unicodes.begin(), glyph.unicodes.end(),
                     [&text](char32_t c) { return tools::to_utf8(c) == text; });
}

// Whether a glyph's name or character, or U+ and its code point, has `text`.
bool matches(const Glyph& glyph, const std::string& text) {
  return is_exact(glyph, text) || glyph.name.find(text) != std::string::npos ||
         character_list(glyph).find(text) != std::string::npos;
}

// Returns whether it is clicked.
bool draw_cell(Panels& panels, const std::string& name, bool is_chosen) {
  const Editor& editor = panels.editor;
  const GlyphPointer glyph = editor.project().find(name, editor.master(name));
  if (glyph == nullptr) {
    return false;
  }
  const float side = px(kCell);
  const float label = px(kLabel);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool is_clicked =
      ImGui::InvisibleButton(name.c_str(), {side, side + label});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 end = {at.x + side, at.y + side + label};
  list.AddRectFilled(at, end, colour::paper, px(3));
  if (is_chosen || ImGui::IsItemHovered()) {
    list.AddRect(at, end, is_chosen ? colour::tool : colour::zone, px(3), 0,
                 is_chosen ? 2.0f : 1.0f);
  }
  ImTextureID texture = panels.textures.find(glyph.get());
  if (texture == nullptr && ImGui::IsItemVisible()) {
    texture = panels.textures.of(
        glyph, glyph.get(),
        thumbnail(editor.shown_project(), *glyph, static_cast<int>(side)));
  }
  if (texture != nullptr) {
    list.AddImage(texture, at, {at.x + side, at.y + side}, {0, 0}, {1, 1},
                  colour::ink);
  }
  const std::string text = label_of(*glyph);
  if (is_undrawn(*glyph)) {  // its character, pale
    const float wide = ImGui::CalcTextSize(text.c_str()).x;
    list.PushClipRect(at, end, true);
    list.AddText({std::round(at.x + (side - wide) / 2), at.y + px(16)},
                 colour::zone, text.c_str());
    list.PopClipRect();
  }
  if (editor.is_changed(name)) {
    list.AddCircleFilled({end.x - px(6), at.y + px(6)}, px(2.5f),
                         colour::selected);
  }
  ImGui::PushFont(tools::small_font());
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  list.PushClipRect(at, end, true);
  list.AddText({std::round(at.x + (side - width) / 2), at.y + side - px(2)},
               colour::faint, text.c_str());
  list.PopClipRect();
  ImGui::PopFont();
  const std::string hint =
      name + (is_undrawn(*glyph) ? ", empty" : "") +
      (editor.is_changed(name) ? ", changed since it was saved" : "");
  tooltip(hint.c_str());
  return is_clicked;
}

float row_height() {
  return px(kCell) + px(kLabel) + px(kGap);
}

int column_count() {
  return std::max(
      1, static_cast<int>((ImGui::GetContentRegionAvail().x + px(kGap)) /
                          (px(kCell) + px(kGap))));
}

// Scrolls to the shown glyph when that changes.
void follow(Panels& panels, const std::vector<std::string>& order) {
  const std::string& shown = panels.editor.glyph_name();
  if (panels.followed == shown) {
    return;
  }
  panels.followed = shown;
  const auto at = std::find(order.begin(), order.end(), shown) - order.begin();
  const float top = static_cast<float>(at / column_count()) * row_height();
  const float room = ImGui::GetWindowHeight() - row_height();
  if (top < ImGui::GetScrollY() || top > ImGui::GetScrollY() + room) {
    ImGui::SetScrollY(top - room / 2);
  }
}

// Returns the name of a glyph that is clicked; else nothing.
std::string draw_cells(Panels& panels,
                       const std::vector<std::string>& order,
                       const std::string& chosen) {
  const int columns = column_count();
  const int count = static_cast<int>(order.size());
  std::string clicked;
  ImGuiListClipper clipper;
  clipper.Begin((count + columns - 1) / columns, row_height());
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart * columns;
         i < std::min(count, clipper.DisplayEnd * columns); ++i) {
      if (i % columns != 0) {
        ImGui::SameLine();
      }
      const std::string& name = order[static_cast<size_t>(i)];
      if (draw_cell(panels, name, name == chosen)) {
        clicked = name;
      }
    }
  }
  return clicked;
}

}  // namespace

std::vector<std::string> found_glyphs(const Project& project,
                                      const std::string& text,
                                      bool is_part) {
  std::vector<std::string> order = glyph_order(project);
  const auto is_left_out = [&](const std::string& name) {
    const Glyph& glyph = *project.find(name);
    return !matches(glyph, text) ||
           (is_part && !is_exact(glyph, text) && glyph.contours.empty() &&
            glyph.components.empty());
  };
  order.erase(std::remove_if(order.begin(), order.end(), is_left_out),
              order.end());
  std::stable_partition(order.begin(), order.end(),
                        [&](const std::string& name) {
                          return is_exact(*project.find(name), text);
                        });
  return order;
}

void draw_glyph_grid(Panels& panels) {
  Editor& editor = panels.editor;
  if (!editor.is_open()) {
    ImGui::TextDisabled("No font is open");
    return;
  }
  const std::vector<std::string> all = glyph_order(editor.project());
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##search", "Search: name, character, U+0041",
                           &panels.search);
  const auto missing =
      std::count_if(all.begin(), all.end(), [&](const std::string& name) {
        return is_undrawn(*editor.project().find(name));
      });
  const std::vector<std::string> order =
      panels.search.empty() ? all
                            : found_glyphs(editor.project(), panels.search);
  if (!panels.search.empty()) {
    ImGui::Text("%zu of %zu glyphs", order.size(), all.size());
  } else {
    ImGui::Text(all.size() == 1 ? "%zu glyph" : "%zu glyphs", all.size());
  }
  if (missing != 0) {
    ImGui::SameLine();
    ImGui::TextDisabled("%zu empty", static_cast<size_t>(missing));
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kGap), px(kGap)));
  ImGui::BeginChild("grid");
  follow(panels, order);
  const std::string clicked = draw_cells(panels, order, editor.glyph_name());
  if (!clicked.empty()) {
    attempt(editor, [&] { editor.show(clicked); });
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

std::string draw_picker(Panels& panels, const std::string& text) {
  const std::vector<std::string> order =
      found_glyphs(panels.editor.project(), text, true);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(kGap), px(kGap)));
  ImGui::BeginChild("picker", {px(520), 4 * row_height()}, true);
  const std::string clicked = draw_cells(
      panels, order, text.empty() || order.empty() ? "" : order.front());
  ImGui::EndChild();
  ImGui::PopStyleVar();
  return clicked;
}

}  // namespace inkcell::design::editor
