// Records what the display shows as a GIF.
#pragma once

#include <filesystem>

#include "simulator.hpp"

namespace inkcell::tools {

/// Whether the scene is animated.
bool is_moving(const Settings& settings);
/// Frames until the scene repeats.
int loop_frames(const Settings& settings);

/// Writes the scene's loop, from its first frame on, at its 30 frames a second;
/// pixels are as large as the setting `zoom`, at least 1. The settings are left
/// as they were. Throws std::runtime_error.
void record(Simulator& simulator, const std::filesystem::path& file);

}  // namespace inkcell::tools
