// Colours and measures of the window. Measures are px at scale 1.
#pragma once

#include <imgui.h>

namespace inkcell::tools {

namespace colour {
inline constexpr ImU32 kPaper = IM_COL32(255, 255, 255, 255);
inline constexpr ImU32 kInk = IM_COL32(34, 38, 46, 255);
inline constexpr ImU32 kFaint = IM_COL32(122, 130, 142, 255);
inline constexpr ImU32 kRule = IM_COL32(221, 225, 231, 255);
inline constexpr ImU32 kFill = IM_COL32(233, 236, 241, 255);
inline constexpr ImU32 kZone = IM_COL32(190, 200, 214, 255);
inline constexpr ImU32 kGuide = IM_COL32(120, 170, 220, 255);
inline constexpr ImU32 kLayer = IM_COL32(196, 150, 196, 255);
inline constexpr ImU32 kWarning = IM_COL32(240, 196, 64, 255);
inline constexpr ImU32 kCorner = IM_COL32(196, 64, 52, 255);
inline constexpr ImU32 kSmooth = IM_COL32(38, 132, 84, 255);
inline constexpr ImU32 kHandle = IM_COL32(94, 122, 176, 255);
inline constexpr ImU32 kSelected = IM_COL32(244, 132, 20, 255);
inline constexpr ImU32 kTool = IM_COL32(30, 110, 214, 255);
inline constexpr ImU32 kComponent = IM_COL32(214, 224, 240, 255);
}  // namespace colour

/// Sets ImGui's colours and spacing for a scale of the screen.
void apply_theme(float scale);

/// Adds the fonts of the window. Call before the first frame.
void add_fonts(float scale);

/// For captions below things; the current font is used elsewhere.
ImFont* small_font();

/// px of the screen for px at scale 1.
float px(float value);

}  // namespace inkcell::tools
