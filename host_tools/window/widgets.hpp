// Widgets that the windows share.
#pragma once

#include <imgui.h>

#include <functional>

namespace inkcell::tools {

/// A text that appears when the pointer rests on the last widget.
void tooltip(const char* text, const char* keys = "");

/// A toggle button; true when it is pressed.
bool choice(const char* label, bool is_chosen, const char* hint);

/// A fixed part of the window; `draw` submits its widgets.
void panel(const char* name,
           ImVec2 at,
           ImVec2 size,
           const std::function<void()>& draw,
           ImGuiWindowFlags flags = 0);

}  // namespace inkcell::tools
