// Controls for scene, display, text and view.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "recording.hpp"
#include "window/panels.hpp"

namespace inkcell::tools {
namespace {

constexpr float kLabel = 84;

struct Named {
  const char* value;
  const char* label;
  const char* hint;
};

// The first of scene_names(), in their order.
constexpr Named kScenes[] = {
    {"text", "Text", "Your text, as inkcell-render draws it. Key: 1"},
    {"demo", "Demo", "The demo of a board: clock, text, a moving line. Key: 2"},
    {"path", "Path", "Letters on a wave. Key: 3"},
    {"clock", "Clock", "Digits that become others. Key: 4"},
    {"particles", "Particles", "A word bursts and becomes another. Key: 5"},
    {"figure13", "Bodies", "Soft letters fall in a heap. Key: 6"},
    {"figure14", "Offsets", "Surfaces swell and throw particles off. Key: 7"},
    {"figure15", "Vortex", "A vortex winds a letter up, and runs back. Key: 8"},
    {"print", "Prints", "Light goes round five prints. Key: 9"},
};
constexpr Named kFilters[] = {
    {"text", "text", "Half a pixel on both sides: the default"},
    {"motion", "motion", "Softer, for what moves"},
    {"paper_display", "paper, display", "The paper's, for large type"},
    {"paper_body", "paper, body", "The paper's, for small type"},
    {"area", "area", "Exact coverage; of outlines, in grey and colour"},
};
constexpr Named kHints[] = {
    {"display", "As device", "Both in 1 and 2 bits, by the canvas; else off"},
    {"none", "Off", "As designed"},
    {"vertical", "Heights", "Heights on whole pixels"},
    {"both", "Both", "Heights, stems and advances on whole pixels"},
    {"auto", "Auto", "Both below 12 px and in 1 and 2 bits, heights above"},
};
constexpr Named kCodings[] = {
    {"outline", "Outline", "Lines and curves: smallest"},
    {"field", "Field", "Cells of nine distances; converting takes seconds"},
};

struct Size {
  int width;
  int height;
};
constexpr Size kSizes[] = {{96, 16},   {128, 32},  {128, 64},
                           {160, 128}, {240, 240}, {320, 240}};

void heading(const char* text) {
  ImGui::Dummy({0, px(3)});
  ImGui::PushFont(small_font());
  ImGui::TextDisabled("%s", text);
  ImGui::PopFont();
  ImGui::Separator();
}

// The label of a form's line; the next widget fills the rest of the line.
void label(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(px(kLabel));
  ImGui::SetNextItemWidth(-1);
}

// Continues the line if a button with this label fits.
void flow(const char* next, bool is_first) {
  if (is_first) {
    return;
  }
  const float width = ImGui::CalcTextSize(next).x +
                      2 * ImGui::GetStyle().FramePadding.x + px(4);
  const float right = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
  if (right + width <= ImGui::GetWindowContentRegionMax().x) {
    ImGui::SameLine(0, px(4));
  }
}

template <size_t kCount>
const char* choices(const Named (&list)[kCount], const std::string& chosen) {
  const char* result = nullptr;
  for (const Named& entry : list) {
    flow(entry.label, &entry == list);
    if (choice(entry.label, chosen == entry.value, entry.hint)) {
      result = entry.value;
    }
  }
  return result;
}

// A slider that the right mouse button resets.
bool slider(const char* id,
            double& value,
            double low,
            double high,
            double home,
            const char* format,
            const char* hint) {
  auto shown = static_cast<float>(value);
  bool is_changed = ImGui::SliderFloat(id, &shown, static_cast<float>(low),
                                       static_cast<float>(high), format,
                                       ImGuiSliderFlags_AlwaysClamp);
  tooltip(hint, "Ctrl+click: type a number. Right click: set back");
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
    shown = static_cast<float>(home);
    is_changed = true;
  }
  if (is_changed) {
    value = std::round(static_cast<double>(shown) * 64) / 64;
  }
  return is_changed;
}

void draw_scene(Panels& panels) {
  Settings& settings = panels.simulator.settings;
  heading("SCENE");
  if (const char* scene = choices(kScenes, settings.scene)) {
    choose_scene(settings, scene);
    panels.is_playing = is_moving(settings);
  }
  ImGui::BeginDisabled(settings.scene == kDemoScene);
  if (settings.scene == kTextScene) {
    ImGui::InputTextMultiline("##text", &settings.text, {-1, px(58)});
  } else {
    ImGui::SetNextItemWidth(-1);
    ImGui::InputText("##text", &settings.text);
  }
  tooltip("What the scene shows: a text, a time HH:MM, or two words");
  ImGui::EndDisabled();
}

void draw_board(Settings& settings) {
  label("Board");
  if (!ImGui::BeginCombo("##board", settings.board.empty()
                                        ? "none"
                                        : settings.board.c_str())) {
    return;
  }
  if (ImGui::Selectable("none", settings.board.empty())) {
    choose_board(settings, "none");
  }
  for (const BoardDisplay* board : board_displays()) {
    if (ImGui::Selectable(board->name, settings.board == board->name)) {
      choose_board(settings, board->name);
    }
  }
  ImGui::EndCombo();
}

void draw_size(Settings& settings) {
  label("Size");
  const auto name_of = [](int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
  };
  const std::string shown = name_of(settings.width, settings.height);
  if (!ImGui::BeginCombo("##size", shown.c_str())) {
    return;
  }
  for (const Size& size : kSizes) {
    const std::string name = name_of(size.width, size.height);
    if (ImGui::Selectable(name.c_str(), name == shown)) {
      choose_board(settings, "none");
      settings.width = size.width;
      settings.height = size.height;
    }
  }
  ImGui::EndCombo();
}

void draw_display(Panels& panels) {
  Settings& settings = panels.simulator.settings;
  heading("DISPLAY");
  draw_board(settings);
  draw_size(settings);
  for (const DisplayInfo& info : display_list()) {
    flow(info.label, &info == &display_list().front());
    if (choice(info.label, info.display == settings.display, info.hint)) {
      choose_display(settings, info.display);
    }
  }
  label("Strip");
  const int step = port::rows_per_stride(display_info(settings.display).format);
  int strides = (settings.rows + step - 1) / step;
  const std::string format = step == 1 ? "%d rows" : "%d pages of 8 rows";
  if (ImGui::SliderInt("##rows", &strides, 1,
                       (settings.height + step - 1) / step, format.c_str(),
                       ImGuiSliderFlags_AlwaysClamp)) {
    settings.rows = strides * step;
  }
  tooltip("Rows in RAM at a time; the picture is the same for every number");
}

void draw_text(Panels& panels) {
  Settings& settings = panels.simulator.settings;
  heading("TEXT");
  ImGui::BeginDisabled(settings.scene != kTextScene);
  label("Size");
  slider("##px", settings.px, 4, 96, 20, "%.2f px/em",
         "In steps of 1/64 px; up to 1024 px/em if you type it");
  label("Weight");
  slider("##weight", settings.weight, -1, 1, 0, "%+.2f px",
         "How far edges move outwards");
  label("Angle");
  slider("##angle", settings.angle, -180, 180, 0, "%.1f degrees",
         "Counter-clockwise");
  label("Shift");
  const float half =
      (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2;
  ImGui::SetNextItemWidth(half);
  slider("##x", settings.shift_x, -2, 2, 0, "x %+.3f",
         "Moves text by parts of a pixel [px]");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  slider("##y", settings.shift_y, -2, 2, 0, "y %+.3f",
         "Moves text by parts of a pixel [px]");
  label("Filter");
  const Named* chosen = std::find_if(
      std::begin(kFilters), std::end(kFilters),
      [&](const Named& entry) { return settings.filter == entry.value; });
  if (ImGui::BeginCombo("##filter", chosen->label)) {
    for (const Named& entry : kFilters) {
      if (ImGui::Selectable(entry.label, &entry == chosen)) {
        settings.filter = entry.value;
      }
      tooltip(entry.hint);
    }
    ImGui::EndCombo();
  }
  label("Grid fitting");
  if (const char* hint = choices(kHints, settings.hint)) {
    settings.hint = hint;
  }
  label("Font of");
  ImGui::BeginDisabled(panels.has_fixed_coding);
  if (const char* coding = choices(kCodings, settings.coding)) {
    settings.coding = coding;
  }
  ImGui::EndDisabled();
  label("Theme");
  if (choice("Dark", settings.is_dark, "White text on black. Key: D")) {
    settings.is_dark = true;
  }
  ImGui::SameLine(0, px(4));
  if (choice("Light", !settings.is_dark, "Black text on white. Key: D")) {
    settings.is_dark = false;
  }
  ImGui::EndDisabled();
}

void draw_view(Panels& panels) {
  Settings& settings = panels.simulator.settings;
  heading("VIEW");
  label("Zoom");
  ImGui::SliderInt("##zoom", &settings.zoom, 0, 32,
                   settings.zoom == 0 ? "fills the window" : "%d x",
                   ImGuiSliderFlags_AlwaysClamp);
  tooltip("Screen pixels a pixel", "Wheel, + and -; 0 fills the window");
  ImGui::Checkbox("Pixel grid", &settings.has_grid);
  tooltip("Lines between pixels, from 4 x on", "G");
  ImGui::SameLine(0, px(18));
  ImGui::BeginDisabled(settings.scene != kTextScene);
  ImGui::Checkbox("Cells, points", &settings.has_overlay);
  tooltip(
      "The quadtree of a font of cells, or the curves and points of an outline "
      "before grid fitting",
      "O");
  ImGui::EndDisabled();
}

void fact(const char* name, const char* format, double value) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(px(150));
  ImGui::Text(format, value);
}

void draw_facts(const Frame& frame) {
  heading("THIS FRAME");
  fact("Strip in RAM", "%.0f bytes", static_cast<double>(frame.strip_bytes));
  if (frame.state_bytes != 0) {
    fact("Scene in RAM", "%.0f bytes", static_cast<double>(frame.state_bytes));
  }
  if (frame.font_bytes != 0) {
    fact("Font in ROM", "%.0f bytes", static_cast<double>(frame.font_bytes));
  }
  if (frame.stats.coverage_pixels + frame.stats.solid_pixels != 0) {
    fact("Pixels computed", "%.0f",
         static_cast<double>(frame.stats.coverage_pixels));
    fact("Pixels filled", "%.0f",
         static_cast<double>(frame.stats.solid_pixels));
  }
}

}  // namespace

void draw_controls(Panels& panels) {
  draw_scene(panels);
  draw_display(panels);
  draw_text(panels);
  draw_view(panels);
  if (const auto frame = panels.simulator.frame()) {
    draw_facts(*frame);
  }
}

}  // namespace inkcell::tools
