// Scripts for the editor: lines of text that call the functions of the window.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

/// A command of scripts: its name, arguments and help.
struct ScriptCommand {
  const char* name;
  const char* arguments;
  const char* task;
};
const std::vector<ScriptCommand>& script_commands();

/// Writes a picture of the window.
using Screenshot =
    std::function<void(Editor& editor, const std::filesystem::path& file)>;

/// Runs one line. Empty lines and lines that begin with # do nothing. Throws
/// std::exception.
void run_script_line(Editor& editor,
                     const std::string& line,
                     const Screenshot& screenshot);

/// Runs a file. Throws Error that names file and line.
void run_script(Editor& editor,
                const std::filesystem::path& file,
                const Screenshot& screenshot);

}  // namespace inkcell::design::editor
