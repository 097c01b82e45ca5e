// One glyph, and the pointer on it.
#include <algorithm>
#include <cmath>

#include "editor/window/outline_layer.hpp"
#include "editor/window/panels.hpp"

namespace inkcell::design::editor {
namespace {

constexpr double kWheelStep = 1.15;

// From this scale on the grid of whole units is shown. [px per unit]
constexpr double kGridScale = 8;

void draw_grid(const View& view, ImVec2 origin) {
  if (view.scale < kGridScale) {
    return;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Point low = view.to_font({0, view.height});
  const Point high = view.to_font({view.width, 0});
  const auto at = [&](double x, double y) {
    const Point p = view.to_canvas({x, y});
    return ImVec2(origin.x + static_cast<float>(p.x),
                  origin.y + static_cast<float>(p.y));
  };
  for (double x = std::ceil(low.x); x <= high.x; ++x) {
    list.AddLine(at(x, low.y), at(x, high.y), colour::fill);
  }
  for (double y = std::ceil(low.y); y <= high.y; ++y) {
    list.AddLine(at(low.x, y), at(high.x, y), colour::fill);
  }
}

Pointer pointer_at(const Editor& editor, ImVec2 origin) {
  const ImGuiIO& io = ImGui::GetIO();
  Pointer pointer;
  pointer.at =
      editor.view.to_font({io.MousePos.x - origin.x, io.MousePos.y - origin.y});
  pointer.reach = px(static_cast<float>(kReach)) / editor.view.scale;
  pointer.shift = io.KeyShift;
  pointer.alt = io.KeyAlt;
  pointer.free = io.KeyCtrl;
  pointer.twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  return pointer;
}

bool pans() {
  return ImGui::IsMouseDown(ImGuiMouseButton_Middle) ||
         SDL_GetKeyboardState(nullptr)[SDL_SCANCODE_SPACE] != 0;
}

void handle_pointer(Editor& editor, ImVec2 origin) {
  const ImGuiIO& io = ImGui::GetIO();
  View& view = editor.view;
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    view.zoom(std::pow(kWheelStep, io.MouseWheel),
              {io.MousePos.x - origin.x, io.MousePos.y - origin.y});
  }
  const bool is_held = ImGui::IsItemActive();
  if (is_held && pans()) {
    view.x -= io.MouseDelta.x / view.scale;
    view.y += io.MouseDelta.y / view.scale;
    return;
  }
  const Pointer pointer = pointer_at(editor, origin);
  const bool is_moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  if (is_moved && (ImGui::IsItemHovered() || is_held)) {
    editor.hover = pointer.at;
  }
  const bool is_released = ImGui::IsItemDeactivated();
  attempt(editor, [&] {
    if (ImGui::IsItemActivated()) {
      editor.tool().press(editor, pointer);
    } else if (is_moved && (is_held || is_released)) {
      editor.tool().drag(editor, pointer);
    }
    if (is_released) {
      editor.tool().release(editor, pointer);
    }
  });
}

void draw_heading(const Editor& editor, ImVec2 origin) {
  const GlyphPointer glyph = editor.glyph();
  char text[160];
  std::snprintf(text, sizeof text, "%s    advance %g    %.0f %%",
                glyph->name.c_str(), glyph->width, 100 * editor.view.scale);
  ImGui::GetWindowDrawList()->AddText({origin.x + px(12), origin.y + px(9)},
                                      colour::ink, text);
}

// What can be opened, before anything is.
void draw_start(Panels& panels, ImVec2 origin, ImVec2 size) {
  const ImVec2 button = {px(240), px(34)};
  const auto place = [&](int row) {
    ImGui::SetCursorScreenPos(
        {origin.x + (size.x - button.x) / 2,
         origin.y + size.y / 2 + px(44) * (static_cast<float>(row) - 1.5f)});
  };
  place(0);
  if (ImGui::Button("Open the sample", button)) {
    attempt(panels.editor, [&] { panels.editor.open_sample(); });
  }
  tooltip("Curves, strokes and parts, in five letters");
  place(1);
  if (ImGui::Button("New font", button)) {
    open_dialog(panels, "New font");
  }
  place(2);
  if (ImGui::Button("Open a font or project", button)) {
    open_dialog(panels, "Open");
  }
}

}  // namespace

void draw_canvas(Panels& panels) {
  Editor& editor = panels.editor;
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  ImGui::GetWindowDrawList()->AddRectFilled(
      origin, {origin.x + size.x, origin.y + size.y}, colour::paper);
  const bool is_resized =
      editor.view.width != size.x || editor.view.height != size.y;
  editor.view.width = size.x;
  editor.view.height = size.y;
  if (!editor.is_open()) {
    draw_start(panels, origin, size);
  }
  if (editor.glyph() == nullptr) {
    return;
  }
  if (is_resized) {
    editor.fit_view();
  }
  ImGui::InvisibleButton(
      "canvas", size,
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle);
  handle_pointer(editor, origin);
  draw_grid(editor.view, origin);
  const OutlineLayer layer(panels, origin);
  if (editor.tool_kind() == ToolKind::spacing) {
    layer.draw_zones();
    layer.draw_line();
    layer.draw_marks();
    draw_heading(editor, origin);
    return;
  }
  const bool is_space =
      SDL_GetKeyboardState(nullptr)[SDL_SCANCODE_SPACE] != 0 &&
      !ImGui::GetIO().WantTextInput;
  if (is_space || editor.shows_black) {
    attempt(editor, [&] { layer.draw_black(); });
    return;
  }
  layer.draw_fill();
  layer.draw_background();
  layer.draw_zones();
  layer.draw_guides();
  layer.draw_layers();
  layer.draw_components();
  layer.draw_cells();
  layer.draw_contours();
  layer.draw_parts();
  layer.draw_strokes();
  layer.draw_points();
  layer.draw_marks();
  draw_heading(editor, origin);
}

}  // namespace inkcell::design::editor
