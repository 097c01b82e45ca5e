// The device's picture.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/window/panels.hpp"

namespace inkcell::design::editor {
namespace {

constexpr float kGlyphHeight = 176;  // of the enlarged glyph's frame
constexpr int kMostEnlarged = 16;

void draw_choices(PreviewSettings& settings) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), px(7)));
  for (const Display display : preview_displays()) {
    if (display != preview_displays().front()) {
      ImGui::SameLine();
    }
    const tools::DisplayInfo& info = tools::display_info(display);
    if (choice(info.label, display == settings.display, info.hint)) {
      settings.display = display;
    }
  }
  ImGui::SameLine(0, px(14));
  if (choice("Dark", settings.dark, "Light text on a dark display. Key: D")) {
    settings.dark = !settings.dark;
  }
  ImGui::PopStyleVar();
}

void picture(Panels& panels,
             const tools::Image& image,
             ImVec2 at,
             int enlarged) {
  const ImTextureID texture = panels.textures.of(panels.preview, &image, image);
  if (texture != nullptr) {
    const auto side = [enlarged](int pixels) {
      return static_cast<float>(pixels * enlarged);
    };
    ImGui::GetWindowDrawList()->AddImage(
        texture, at, {at.x + side(image.width), at.y + side(image.height)});
  }
}

// Draws a frame in the colour of the display; returns its upper left corner.
ImVec2 frame(const PreviewSettings& settings, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 end = {at.x + width, at.y + height};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, end,
                     settings.dark ? IM_COL32(0, 0, 0, 255) : colour::kPaper);
  list.AddRect(at, end, colour::kRule);
  ImGui::Dummy({width, height});
  return at;
}

void draw_glyph(Panels& panels, const Preview& preview) {
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = frame(panels.editor.preview, px(kGlyphHeight));
  const tools::Image& image = preview.glyph;
  if (image.width == 0) {
    return;
  }
  const auto fits = [](float side, int pixels) {
    return static_cast<int>(side) / pixels;
  };
  const int enlarged = std::clamp(
      std::min(fits(px(kGlyphHeight), image.height), fits(width, image.width)),
      1, kMostEnlarged);
  const auto centred = [enlarged](float side, int pixels) {
    return std::round((side - static_cast<float>(pixels * enlarged)) / 2);
  };
  picture(panels, image,
          {at.x + centred(width, image.width),
           at.y + centred(px(kGlyphHeight), image.height)},
          enlarged);
}

void draw_lines(Panels& panels, const Preview& preview) {
  for (const TextPicture& line : preview.lines) {
    ImGui::TextDisabled("%g px", line.px);
    const float width = ImGui::GetContentRegionAvail().x;
    const float inset = px(4);
    const int fits =
        static_cast<int>(width - 2 * inset) / std::max(line.image.width, 1);
    const int enlarged = std::clamp(fits, 1, static_cast<int>(px(2)));
    const ImVec2 at =
        frame(panels.editor.preview,
              static_cast<float>(line.image.height * enlarged) + 2 * inset);
    ImGui::PushClipRect(at, {at.x + width, at.y + 1000}, true);
    picture(panels, line.image, {at.x + inset, at.y + inset}, enlarged);
    ImGui::PopClipRect();
  }
}

void draw_facts(const Preview& preview, bool cells) {
  if (preview.is_exact) {
    ImGui::TextDisabled("Exact distance; the device's pixels follow");
    return;
  }
  ImGui::Text("%zu bytes, %zu points", preview.glyph_bytes,
              preview.glyph_points);
  tooltip("The glyph's record in an Inkcell font of outlines");
  ImGui::SameLine(0, px(16));
  ImGui::Text("worst pixel %.0f/255 at %d px", preview.worst_error,
              preview.worst_px);
  tooltip(
      "The largest difference from exact coverage, of all sizes from 8 to 64 "
      "px and 8 positions between pixels");
  if (cells) {
    ImGui::TextDisabled("As a field: %zu cells, %zu bytes",
                        preview.cells.size(), preview.cell_bytes);
  }
}

}  // namespace

void draw_preview_panel(Panels& panels) {
  Editor& editor = panels.editor;
  PreviewSettings& settings = editor.preview;
  draw_choices(settings);
  ImGui::SetNextItemWidth(px(130));
  auto size = static_cast<float>(settings.glyph_px);
  if (ImGui::DragFloat("##size", &size, 0.25f, 8, 64, "Glyph at %.0f px",
                       ImGuiSliderFlags_AlwaysClamp)) {
    settings.glyph_px = std::round(size);
  }
  tooltip("Drag to the sides to change the size");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##text", &settings.text);
  tooltip("The text of the lines below");
  if (panels.preview == nullptr) {
    ImGui::TextDisabled(panels.preview_is_busy ? "Drawing..." : "");
    return;
  }
  const Preview& preview = *panels.preview;
  if (!preview.error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour::kCorner);
    ImGui::TextWrapped("%s", preview.error.c_str());
    ImGui::PopStyleColor();
    return;
  }
  draw_glyph(panels, preview);
  draw_facts(preview, settings.cells);
  if (!preview.missing.empty()) {
    ImGui::TextDisabled("Not in the font: %s", preview.missing.c_str());
  }
  draw_lines(panels, preview);
}

}  // namespace inkcell::design::editor
