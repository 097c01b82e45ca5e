// Converts values of Lua to data of commands, and back.
#pragma once

#include <lua.hpp>

#include "model/value.hpp"

namespace inkcell::design {

/// The value at `index` of the stack. A table of integers from 1 is an array,
/// its holes are null; a table of names is a dictionary; an empty one is an
/// array. Integral numbers become integers. Raises a Lua error for functions,
/// numbers that are not finite, and tables that contain themselves.
Value value_of(lua_State* lua, int index);

/// Pushes `value`. null is the light userdata that scripts call `null`.
void push_value(lua_State* lua, const Value& value);

}  // namespace inkcell::design
