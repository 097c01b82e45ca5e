// Scale, slant and turn of the selection, shown while sliders move.
#include <cmath>

#include "editor/edits.hpp"
#include "editor/window/panels.hpp"

namespace inkcell::design::editor {

void draw_transform(Panels& panels) {
  Editor& editor = panels.editor;
  auto& values = panels.transform;
  ImGui::SetNextWindowPos({px(310), px(60)}, ImGuiCond_Appearing);
  ImGui::Begin(kTransform, nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::TextDisabled(editor.component           ? "The component"
                      : editor.selection.empty() ? "The whole glyph"
                                                 : "The selected points");
  bool is_changed =
      ImGui::DragFloat("Width", &values.x, 0.5f, 1, 1000, "%.1f %%");
  is_changed |= ImGui::DragFloat("Height", &values.y, 0.5f, 1, 1000, "%.1f %%");
  is_changed |=
      ImGui::SliderFloat("Slant", &values.slant, -45, 45, "%.1f degrees");
  is_changed |=
      ImGui::SliderFloat("Turn", &values.turn, -180, 180, "%.1f degrees");
  if (is_changed) {
    attempt(editor, [&] {
      // In steps of 1/10, as shown.
      const auto tenths = [](float value) { return std::round(10.0 * value); };
      editor.propose(transform_selection(
          editor,
          {{"scale", {tenths(values.x) / 1000, tenths(values.y) / 1000}},
           {"slant", tenths(values.slant) / 10},
           {"turn", tenths(values.turn) / 10}}));
    });
  }
  draw_apply_or_cancel(panels);
  ImGui::End();
}

}  // namespace inkcell::design::editor
