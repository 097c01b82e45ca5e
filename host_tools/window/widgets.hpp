// Widgets that the windows share.
#pragma once

#include <imgui.h>

#include <functional>

namespace inkcell::tools {

/// A text that appears over the last widget when the pointer rests on it.
void tooltip(const char* text, const char* keys = "");

/// A button that stays pressed; true when it is pressed now.
bool choice(const char* label, bool is_chosen, const char* hint);

/// A part of the window that stays where it is, whose widgets `draw` submits.
void panel(const char* name,
           ImVec2 at,
           ImVec2 size,
           const std::function<void()>& draw,
           ImGuiWindowFlags flags = 0);

}  // namespace inkcell::tools
