// The actions of keys, menus and scripts, by name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

struct Action {
  const char* name;  // in menus
  const char* keys;  // "ctrl+z", alternatives separated by spaces; may be ""
  std::function<void(Editor&)> run;
};

/// All actions, including tools and nudges.
const std::vector<Action>& action_list();

/// An action of a menu. Throws Error if there is none of this name.
const Action& action(const std::string& name);

/// Runs the action of a key: lower case, prefixed by ctrl+ and shift+ in this
/// order. False if the key has no action, or nothing is open.
bool press_key(Editor& editor, const std::string& key);

}  // namespace inkcell::design::editor
