// The simulator from a text file: for tests, and for pictures of documents.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "simulator.hpp"

namespace inkcell::tools {

/// Writes a picture of the window.
using Screenshot =
    std::function<void(Simulator& simulator, const std::filesystem::path&)>;

/// What scripts can do beside settings: name, arguments and task.
struct ScriptCommand {
  const char* name;
  const char* arguments;
  const char* task;
};
const std::vector<ScriptCommand>& script_commands();

/// Carries out a file line by line; lines that begin with # and empty ones do
/// nothing. Throws std::runtime_error that names the line.
void run_script(Simulator& simulator,
                const std::filesystem::path& file,
                const Screenshot& screenshot);

/// Writes the display's picture, or with .bin the bytes of its memory.
void save_frame(const Frame& frame, const std::filesystem::path& file);

}  // namespace inkcell::tools
