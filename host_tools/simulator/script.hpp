// Runs the simulator by scripts: for tests, and for pictures in documents.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "simulator.hpp"

namespace inkcell::tools {

/// Writes a picture of the window.
using Screenshot =
    std::function<void(Simulator& simulator, const std::filesystem::path&)>;

/// A command of scripts beside settings: name, arguments and help.
struct ScriptCommand {
  const char* name;
  const char* arguments;
  const char* task;
};
const std::vector<ScriptCommand>& script_commands();

/// Runs a file line by line; empty lines and lines that begin with # do
/// nothing. Throws std::runtime_error that names the line.
void run_script(Simulator& simulator,
                const std::filesystem::path& file,
                const Screenshot& screenshot);

/// Writes the display's picture, or its memory if the suffix is .bin.
void save_frame(const Frame& frame, const std::filesystem::path& file);

}  // namespace inkcell::tools
