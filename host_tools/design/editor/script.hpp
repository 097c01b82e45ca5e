// The editor driven by lines of text, through the same functions as the window.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// A command of scripts: its name, arguments and task, for the help.
struct ScriptCommand {
  const char* name;
  const char* arguments;
  const char* task;
};
const std::vector<ScriptCommand>& script_commands();

/// Writes a picture of the window.
using Screenshot =
    std::function<void(Editor& editor, const std::filesystem::path& file)>;

/// Carries out one line. Empty lines, and lines that begin with #, do nothing.
/// Throws std::exception.
void run_script_line(Editor& editor,
                     const std::string& line,
                     const Screenshot& screenshot);

/// Carries out all lines of a file. Throws Error that names file and line.
void run_script(Editor& editor,
                const std::filesystem::path& file,
                const Screenshot& screenshot);

}  // namespace inkcell::design::editor
