// Programs in Lua on the project that is open.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "model/project.hpp"
#include "script/lua_script.hpp"

namespace inkcell::design::editor {

struct LuaRun {
  std::filesystem::path file;
  std::vector<ScriptParameter> parameters;
  Value command;  // all that the program does, as one step
  size_t commands = 0;
};

/// What a program does to a project. A glyph that exists already is drawn
/// anew: its advance and characters are those of add_glyph, and what it was
/// made of goes. Throws Error.
LuaRun run_lua(const Project& project,
               const std::filesystem::path& file,
               const std::map<std::string, double>& settings);

}  // namespace inkcell::design::editor
