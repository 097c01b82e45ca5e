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

struct Colour {
  ImU32& value;
  ImU32 light;
  ImU32 dark;
};

const Colour kColours[] = {
    {colour::paper, IM_COL32(255, 255, 255, 255), IM_COL32(30, 32, 37, 255)},
    {colour::ink, IM_COL32(34, 38, 46, 255), IM_COL32(222, 226, 233, 255)},
    {colour::faint, IM_COL32(122, 130, 142, 255), IM_COL32(138, 146, 158, 255)},
    {colour::rule, IM_COL32(221, 225, 231, 255), IM_COL32(62, 66, 74, 255)},
    {colour::fill, IM_COL32(233, 236, 241, 255), IM_COL32(58, 63, 72, 255)},
    {colour::zone, IM_COL32(190, 200, 214, 255), IM_COL32(74, 82, 96, 255)},
    {colour::guide, IM_COL32(120, 170, 220, 255), IM_COL32(78, 128, 180, 255)},
    {colour::layer, IM_COL32(196, 150, 196, 255), IM_COL32(196, 150, 196, 255)},
    {colour::warning, IM_COL32(240, 196, 64, 255), IM_COL32(240, 196, 64, 255)},
    {colour::corner, IM_COL32(196, 64, 52, 255), IM_COL32(240, 110, 96, 255)},
    {colour::smooth, IM_COL32(38, 132, 84, 255), IM_COL32(92, 196, 136, 255)},
    {colour::handle, IM_COL32(94, 122, 176, 255), IM_COL32(134, 164, 216, 255)},
    {colour::selected, IM_COL32(244, 132, 20, 255),
     IM_COL32(244, 132, 20, 255)},
    {colour::tool, IM_COL32(30, 110, 214, 255), IM_COL32(70, 144, 240, 255)},
    {colour::component, IM_COL32(214, 224, 240, 255),
     IM_COL32(52, 66, 90, 255)},
    {colour::raised, IM_COL32(224, 229, 236, 255), IM_COL32(52, 56, 64, 255)},
};

bool is_dark_theme = false;

// `level` of the light theme; the dark one is darker and has less contrast.
ImVec4 grey(float level) {
  const float shown = is_dark_theme ? 0.14f + 0.9f * (0.968f - level) : level;
  return {shown, shown * 1.004f, shown * 1.012f, 1};
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

void apply_theme(float scale, bool is_dark) {
  screen_scale = scale;
  is_dark_theme = is_dark;
  for (const Colour& each : kColours) {
    each.value = is_dark ? each.dark : each.light;
  }
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();  // ScaleAllSizes() multiplies
  is_dark ? ImGui::StyleColorsDark() : ImGui::StyleColorsLight();
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
  const ImVec4 accent = ImGui::ColorConvertU32ToFloat4(colour::tool);
  const auto tint = [&accent](float alpha) {
    return ImVec4(accent.x, accent.y, accent.z, alpha);
  };
  colours[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(colour::ink);
  colours[ImGuiCol_TextDisabled] =
      ImGui::ColorConvertU32ToFloat4(colour::faint);
  colours[ImGuiCol_WindowBg] = grey(0.968f);
  colours[ImGuiCol_MenuBarBg] = grey(0.968f);
  colours[ImGuiCol_PopupBg] = grey(0.995f);
  colours[ImGuiCol_ChildBg] = grey(0.968f);
  colours[ImGuiCol_Border] = ImGui::ColorConvertU32ToFloat4(colour::rule);
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

void set_dark(bool is_dark) {
  apply_theme(screen_scale, is_dark);
}

}  // namespace inkcell::tools
