// Colours and measures of the window. Measures are px at scale 1.
#pragma once

#include <imgui.h>

namespace inkcell::tools {

namespace colour {
// Of the theme that apply_theme() set last.
inline ImU32 paper = 0;
inline ImU32 ink = 0;
inline ImU32 faint = 0;
inline ImU32 rule = 0;
inline ImU32 fill = 0;
inline ImU32 zone = 0;
inline ImU32 guide = 0;
inline ImU32 layer = 0;
inline ImU32 warning = 0;
inline ImU32 corner = 0;
inline ImU32 smooth = 0;
inline ImU32 handle = 0;
inline ImU32 selected = 0;
inline ImU32 tool = 0;
inline ImU32 component = 0;
inline ImU32 raised = 0;
}  // namespace colour

/// Sets the colours above, and ImGui's colours and spacing for a scale of the
/// screen.
void apply_theme(float scale, bool is_dark = false);
/// The same for the scale that was set last.
void set_dark(bool is_dark);

/// Adds the fonts of the window. Call before the first frame.
void add_fonts(float scale);

/// For captions below things; the current font is used elsewhere.
ImFont* small_font();

/// px of the screen for px at scale 1.
float px(float value);

}  // namespace inkcell::tools
