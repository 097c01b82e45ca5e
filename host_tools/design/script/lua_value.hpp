// Values of Lua as data of commands, and back.
#pragma once

#include <lua.hpp>

#include "model/value.hpp"

namespace inkcell::design {

/// The value at `index` of the stack. A table of whole numbers from 1 is an
/// array, whose holes are null; a table of names is a dictionary; an empty one
/// is an array. Whole numbers become integers. Raises an error of Lua for
/// functions, numbers that are not finite, and tables that hold themselves.
Value value_of(lua_State* lua, int index);

/// Pushes `value`. null is the light userdata that scripts know as `null`.
void push_value(lua_State* lua, const Value& value);

}  // namespace inkcell::design
