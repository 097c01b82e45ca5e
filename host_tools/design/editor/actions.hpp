// What keys, menus and scripts do, by name.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "editor/editor.hpp"

namespace inkcell::design::editor {

struct Action {
  const char* name;  // as menus show it
  const char* keys;  // "ctrl+z", several divided by spaces; "" if there is none
  std::function<void(Editor&)> run;
};

/// All actions; tools and nudges among them.
const std::vector<Action>& action_list();

/// The action of a menu. It must exist.
const Action& action(const std::string& name);

/// Carries out what a key stands for: lower case, with ctrl+, shift+ before it
/// in this order. False if it stands for nothing, or nothing is open.
bool press_key(Editor& editor, const std::string& key);

}  // namespace inkcell::design::editor
