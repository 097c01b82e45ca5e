// Lua scripts that run commands.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "journal/session.hpp"

namespace inkcell::design {

/// A parameter of a script and its range; both ends are the default value if
/// the script states none.
struct ScriptParameter {
  std::string name;
  double value = 0;
  double least = 0;
  double most = 0;
};

struct ScriptOptions {
  /// Values of the script's parameters, by name.
  std::map<std::string, double> settings;
  /// The most Lua instructions of a script.
  size_t most_steps = 100'000'000;
  /// The most memory of a script. [bytes]
  size_t most_bytes = size_t{256} << 20;
  /// Gives the script Lua's io, os and require: the files and programs of the
  /// machine. Otherwise a script can only access its project.
  bool is_trusted = false;
};

/// Runs a script. Every command of model/commands.hpp is a function that takes
/// the arguments as a table; script/pens.lua adds pens and curves. `play` is
/// called with each command and changes `project`, which glyph() and glyphs()
/// read. Scripts are deterministic.
///
/// Throws Error that names the script and the line for any failure in it, and
/// for settings that the script does not have. Returns the parameters that it
/// asked for.
std::vector<ScriptParameter> run_script(
    const std::filesystem::path& file,
    const ScriptOptions& options,
    const std::function<const Project&()>& project,
    const std::function<void(const Value& command)>& play);

/// Adds "NAME=NUMBER" to the settings. Throws Error.
void add_setting(const std::string& text, ScriptOptions& options);

}  // namespace inkcell::design
