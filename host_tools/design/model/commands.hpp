// Commands as data: every change of a project is a dictionary.
//
//   { "do": "move_points", "glyph": "a", "points": [[0, 3]], "dx": 10 }
//
// A command always does the same to the same project, so that a list of them
// is a journal, a macro and a test script at once. docs/EDITING.md lists them.
#pragma once

#include <string>
#include <vector>

#include "model/project.hpp"

namespace inkcell::design {

/// What `command` changes. `project` stays as it is.
///
/// Throws Error that names the command, the glyph and the argument, and says
/// what is allowed.
Change change_of(const Project& project, const Value& command);

/// Names of all commands, sorted.
std::vector<std::string> command_names();

}  // namespace inkcell::design
