// Commands as data: every change of a project is a dictionary.
//
//   { "do": "move_points", "glyph": "a", "points": [[0, 3]], "dx": 10 }
//
// Commands are deterministic: the same list on the same project gives the same
// result, so a list is a journal, a macro and a test script. EDITING.md
// lists them.
#pragma once

#include <string>
#include <vector>

#include "model/project.hpp"

namespace inkcell::design {

/// The change that `command` makes. `project` is not modified.
///
/// Throws Error that names the command, the glyph, the argument, and what is
/// allowed.
Change change_of(const Project& project, const Value& command);

/// Names of all commands, sorted.
std::vector<std::string> command_names();

}  // namespace inkcell::design
