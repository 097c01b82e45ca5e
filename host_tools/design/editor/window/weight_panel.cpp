// Weight and offset of the glyph, shown while sliders move.
#include <cmath>

#include "editor/window/panels.hpp"

namespace inkcell::design::editor {
namespace {

constexpr float kBarsOfStems = 0.6f;  // until the other slider moves
constexpr const char* kSides[] = {"outside", "inside", "both"};

Value command_of(const WeightValues& values) {
  if (values.is_offset) {
    return {{"do", "offset"},
            {"by", std::round(std::abs(values.by))},
            {"side", kSides[values.side]}};
  }
  Value command = {{"do", "change_weight"},
                   {"by", std::round(values.by)},
                   {"bars", std::round(values.bars)},
                   {"counters", std::round(values.counters)}};
  if (values.keeps_advance) {
    command["advance"] = "keep";
  }
  return command;
}

// Returns whether something has changed.
bool draw_values(WeightValues& values, float most) {
  int kind = values.is_offset ? 1 : 0;
  bool is_changed = ImGui::RadioButton("Weight", &kind, 0);
  ImGui::SameLine(0, px(18));
  is_changed |= ImGui::RadioButton("Offset", &kind, 1);
  values.is_offset = kind == 1;
  if (values.is_offset) {
    is_changed |= ImGui::SliderFloat("Units", &values.by, 1, most, "%.0f");
    is_changed |= ImGui::Combo("Side", &values.side, kSides, 3);
    tooltip("Both: a line along the outline, twice as wide");
    return is_changed;
  }
  if (ImGui::SliderFloat("Stems", &values.by, -most, most, "%+.0f")) {
    values.bars = kBarsOfStems * values.by;
    is_changed = true;
  }
  tooltip("Units by which upright stems get wider; heights stay");
  is_changed |= ImGui::SliderFloat("Bars", &values.bars, -most, most, "%+.0f");
  tooltip("Units by which level bars get thicker");
  is_changed |=
      ImGui::SliderFloat("Counters", &values.counters, 0, 100, "%.0f %% kept");
  tooltip("100: counters stay and the glyph gets wider; 0: counters give all");
  is_changed |= ImGui::Checkbox("Keep the advance", &values.keeps_advance);
  tooltip("Else both side bearings stay");
  return is_changed;
}

}  // namespace

void draw_weight(Panels& panels) {
  Editor& editor = panels.editor;
  WeightValues& values = panels.weight;
  ImGui::SetNextWindowPos({px(310), px(60)}, ImGuiCond_Appearing);
  ImGui::Begin(kWeight, nullptr,
               ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  const auto most =
      static_cast<float>(std::round(editor.project().units_per_em() / 8));
  const bool is_changed = draw_values(values, most);
  if (is_changed) {
    attempt(editor, [&] {
      editor.propose(std::round(values.by) == 0 && values.bars == 0
                         ? Value()
                         : command_of(values));
    });
  }
  draw_apply_or_cancel(panels);
  ImGui::End();
}

}  // namespace inkcell::design::editor
