// The device's picture.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "editor/window/panels.hpp"

namespace inkcell::design::editor {
namespace {

constexpr float kGlyphHeight = 176;  // of the enlarged glyph's frame
constexpr int kMostEnlarged = 24;

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
  list.AddRectFilled(at, end, settings.dark ? IM_COL32_BLACK : IM_COL32_WHITE);
  list.AddRect(at, end, colour::rule);
  ImGui::Dummy({width, height});
  return at;
}

// The pixels that differ from the background, with one around them.
struct PixelBox {
  int x0;
  int y0;
  int x1;
  int y1;
};

PixelBox ink_of(const tools::Image& image) {
  PixelBox box = {image.width, image.height, 0, 0};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!std::equal(image.at(0, 0), image.at(0, 0) + image.channels,
                      image.at(x, y))) {
        box = {std::min(box.x0, x - 1), std::min(box.y0, y - 1),
               std::max(box.x1, x + 2), std::max(box.y1, y + 2)};
      }
    }
  }
  if (box.x1 == 0) {
    return {0, 0, image.width, image.height};
  }
  return {std::max(box.x0, 0), std::max(box.y0, 0),
          std::min(box.x1, image.width), std::min(box.y1, image.height)};
}

// The glyph's ink, as large as it fits.
void draw_glyph(Panels& panels, const Preview& preview) {
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 at = frame(panels.editor.preview, px(kGlyphHeight));
  const tools::Image& image = preview.glyph;
  if (image.width == 0) {
    return;
  }
  const PixelBox ink = ink_of(image);
  const auto fits = [](float side, int pixels) {
    return static_cast<int>(side) / pixels;
  };
  const int enlarged =
      std::clamp(std::min(fits(px(kGlyphHeight), ink.y1 - ink.y0),
                          fits(width, ink.x1 - ink.x0)),
                 1, kMostEnlarged);
  const auto place = [enlarged](float side, int low, int high) {
    const auto size = static_cast<float>((high - low) * enlarged);
    return std::round((side - size) / 2) - static_cast<float>(low * enlarged);
  };
  ImGui::PushClipRect({at.x + 1, at.y + 1},
                      {at.x + width - 1, at.y + px(kGlyphHeight) - 1}, true);
  picture(panels, image,
          {at.x + place(width, ink.x0, ink.x1),
           at.y + place(px(kGlyphHeight), ink.y0, ink.y1)},
          enlarged);
  ImGui::PopClipRect();
}

void draw_lines(Panels& panels, const Preview& preview) {
  const float width = ImGui::GetContentRegionAvail().x;
  const float inset = px(4);
  // All lines alike, so that sizes can be compared.
  auto enlarged = static_cast<int>(px(2));
  for (const TextPicture& line : preview.lines) {
    const int fits =
        static_cast<int>(width - 2 * inset) / std::max(line.image.width, 1);
    enlarged = std::clamp(fits, 1, enlarged);
  }
  for (const TextPicture& line : preview.lines) {
    ImGui::TextDisabled("%g px, enlarged %d times", line.px, enlarged);
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
  if (preview.glyph_points == 0) {
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
  ImGui::InputText("##text", &settings.text, ImGuiInputTextFlags_AutoSelectAll);
  tooltip("The text of the lines below");
  if (panels.preview == nullptr) {
    ImGui::TextDisabled(panels.preview_is_busy ? "Drawing..." : "");
    return;
  }
  const Preview& preview = *panels.preview;
  if (!preview.error.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour::corner);
    ImGui::TextWrapped("%s", preview.error.c_str());
    ImGui::PopStyleColor();
    return;
  }
  draw_glyph(panels, preview);
  draw_facts(preview, settings.cells);
  if (!preview.missing.empty()) {
    ImGui::TextDisabled("Not in the font: %s", preview.missing.c_str());
  }
  if (!preview.undrawn.empty()) {
    ImGui::TextDisabled("Empty: %s", preview.undrawn.c_str());
  }
  draw_lines(panels, preview);
}

}  // namespace inkcell::design::editor
