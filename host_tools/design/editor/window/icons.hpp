// Icons of the tools, drawn as lines.
#pragma once

#include <imgui.h>

#include "editor/tool.hpp"

namespace inkcell::design::editor {

/// In a square of `side` px from `at`.
void draw_icon(ToolKind kind, ImVec2 at, float side, ImU32 colour);

}  // namespace inkcell::design::editor
