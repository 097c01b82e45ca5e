#include "window/theme.hpp"

#include <imgui_freetype.h>

#include <cmath>
#include <filesystem>

namespace inkcell::tools {
namespace {

constexpr float kFontSize = 15;  // [px]
constexpr float kSmallSize = 11;

// The first one that exists, else ImGui's own font.
constexpr const char* kFonts[] = {
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
};

// Latin, and the signs of the menu.
constexpr ImWchar kRanges[] = {0x20, 0x17F, 0x2010, 0x2040, 0};

// Set once, before the first frame.
float screen_scale = 1;

ImVec4 grey(float level, float alpha = 1) {
  return {level, level * 1.004f, level * 1.012f, alpha};
}

}  // namespace

void add_fonts(float scale) {
  ImFontConfig config;
  config.OversampleH = 1;  // the renderer takes the nearest sample
  config.PixelSnapH = true;
  config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  const char* file = nullptr;
  for (const char* candidate : kFonts) {
    if (file == nullptr && std::filesystem::exists(candidate)) {
      file = candidate;
    }
  }
  for (const float size : {kFontSize, kSmallSize}) {
    if (file == nullptr) {
      fonts.AddFontDefault();
    } else {
      fonts.AddFontFromFileTTF(file, std::round(size * scale), &config,
                               kRanges);
    }
  }
}

ImFont* small_font() {
  return ImGui::GetIO().Fonts->Fonts[1];
}

float px(float value) {
  return std::round(value * screen_scale);
}

void apply_theme(float scale) {
  screen_scale = scale;
  ImGui::StyleColorsLight();
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = {12, 10};
  style.FramePadding = {8, 4};
  style.ItemSpacing = {8, 7};
  style.ItemInnerSpacing = {6, 5};
  style.WindowRounding = 0;
  style.FrameRounding = 3;
  style.PopupRounding = 4;
  style.GrabRounding = 3;
  style.ScrollbarRounding = 4;
  style.ScrollbarSize = 11;
  style.WindowBorderSize = 1;
  style.FrameBorderSize = 0;
  style.AntiAliasedLinesUseTex = false;  // no bi-linear samples in software
  style.ScaleAllSizes(scale);
  ImVec4* colours = style.Colors;
  const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(colour::kTool);
  const auto tint = [&accent](float alpha) {
    return ImVec4(accent.x, accent.y, accent.z, alpha);
  };
  colours[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(colour::kInk);
  colours[ImGuiCol_TextDisabled] =
      ImGui::ColorConvertU32ToFloat4(colour::kFaint);
  colours[ImGuiCol_WindowBg] = grey(0.968f);
  colours[ImGuiCol_MenuBarBg] = grey(0.968f);
  colours[ImGuiCol_PopupBg] = grey(0.995f);
  colours[ImGuiCol_ChildBg] = grey(0.968f);
  colours[ImGuiCol_Border] = ImGui::ColorConvertU32ToFloat4(colour::kRule);
  colours[ImGuiCol_Separator] = colours[ImGuiCol_Border];
  colours[ImGuiCol_FrameBg] = grey(0.905f);
  colours[ImGuiCol_FrameBgHovered] = grey(0.875f);
  colours[ImGuiCol_FrameBgActive] = grey(0.85f);
  colours[ImGuiCol_Button] = grey(0.905f);
  colours[ImGuiCol_ButtonHovered] = grey(0.86f);
  colours[ImGuiCol_ButtonActive] = grey(0.82f);
  colours[ImGuiCol_Header] = tint(0.16f);
  colours[ImGuiCol_HeaderHovered] = tint(0.12f);
  colours[ImGuiCol_HeaderActive] = tint(0.22f);
  colours[ImGuiCol_CheckMark] = accent;
  colours[ImGuiCol_SliderGrab] = tint(0.7f);
  colours[ImGuiCol_SliderGrabActive] = accent;
  colours[ImGuiCol_ScrollbarBg] = grey(0.968f);
  colours[ImGuiCol_ScrollbarGrab] = grey(0.82f);
}

}  // namespace inkcell::tools
