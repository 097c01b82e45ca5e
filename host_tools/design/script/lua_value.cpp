#include "script/lua_value.hpp"

#include <cmath>
#include <string>

namespace inkcell::design {
namespace {

// The deepest nesting of tables, more than commands need.
constexpr int kMostDepth = 32;

// The most holes of an array for each element.
constexpr lua_Integer kMostHoles = 4;

// Doubles that are whole numbers up to here are exact.
constexpr double kMostExact = 9007199254740992.0;

Value value_at(lua_State* lua, int index, int depth);

// The same type as parsed JSON: unsigned unless it is negative.
Value whole(lua_Integer number) {
  return number < 0 ? Value(number) : Value(static_cast<uint64_t>(number));
}

Value number_at(lua_State* lua, int index) {
  if (lua_isinteger(lua, index)) {
    return whole(lua_tointeger(lua, index));
  }
  const double number = lua_tonumber(lua, index);
  if (!std::isfinite(number)) {
    luaL_error(lua, "a number is not finite: a division by zero?");
  }
  if (number == std::floor(number) && std::fabs(number) < kMostExact) {
    return whole(static_cast<lua_Integer>(number));
  }
  return number;
}

// Adds the pair of key and value on top of the stack.
void add_pair(lua_State* lua, Value& names, Value& items, int depth) {
  if (lua_type(lua, -2) == LUA_TSTRING) {
    names[lua_tostring(lua, -2)] = value_at(lua, lua_gettop(lua), depth + 1);
    return;
  }
  const lua_Integer at = lua_isinteger(lua, -2) ? lua_tointeger(lua, -2) : 0;
  const lua_Integer most =
      kMostHoles * (static_cast<lua_Integer>(items.size()) + 2);
  const bool is_next = at > 0 && at <= most;
  if (!is_next) {
    luaL_error(lua, "a table's keys are neither names nor numbers from 1");
  }
  const size_t i = static_cast<size_t>(at - 1);
  while (items.size() <= i) {
    items.push_back(nullptr);
  }
  items[i] = value_at(lua, lua_gettop(lua), depth + 1);
}

Value table_at(lua_State* lua, int index, int depth) {
  if (depth > kMostDepth) {
    luaL_error(lua, "tables within tables %d deep", kMostDepth);
  }
  luaL_checkstack(lua, 4, "a table");
  Value names = Value::object();
  Value items = Value::array();
  // The array first, in order; lua_next() has no order.
  const lua_Integer length = static_cast<lua_Integer>(lua_rawlen(lua, index));
  for (lua_Integer i = 1; i <= length; ++i) {
    lua_pushinteger(lua, i);
    lua_rawgeti(lua, index, i);
    add_pair(lua, names, items, depth);
    lua_pop(lua, 2);
  }
  lua_pushnil(lua);
  while (lua_next(lua, index) != 0) {
    const bool is_done = lua_isinteger(lua, -2) &&
                         lua_tointeger(lua, -2) >= 1 &&
                         lua_tointeger(lua, -2) <= length;
    if (!is_done) {
      add_pair(lua, names, items, depth);
    }
    lua_pop(lua, 1);
  }
  if (!names.empty() && !items.empty()) {
    luaL_error(lua, "a table has both names and a list");
  }
  return names.empty() ? items : names;
}

Value value_at(lua_State* lua, int index, int depth) {
  switch (lua_type(lua, index)) {
    case LUA_TNUMBER:
      return number_at(lua, index);
    case LUA_TBOOLEAN:
      return lua_toboolean(lua, index) != 0;
    case LUA_TSTRING:
      return lua_tostring(lua, index);
    case LUA_TTABLE:
      return table_at(lua, index, depth);
    case LUA_TNIL:
    case LUA_TLIGHTUSERDATA:
      return nullptr;
    default:
      luaL_error(lua, "a %s is no data of a command",
                 luaL_typename(lua, index));
      return nullptr;
  }
}

}  // namespace

Value value_of(lua_State* lua, int index) {
  return value_at(lua, lua_absindex(lua, index), 0);
}

void push_value(lua_State* lua, const Value& value) {
  luaL_checkstack(lua, 4, "a value");
  if (value.is_object() || value.is_array()) {
    lua_newtable(lua);
    lua_Integer next = 1;
    for (const auto& [key, item] : value.items()) {
      push_value(lua, item);
      if (value.is_object()) {
        lua_setfield(lua, -2, key.c_str());
      } else {
        lua_rawseti(lua, -2, next++);
      }
    }
  } else if (value.is_string()) {
    const std::string& text = value.get_ref<const std::string&>();
    lua_pushlstring(lua, text.data(), text.size());
  } else if (value.is_number_integer()) {
    lua_pushinteger(lua, value.get<lua_Integer>());
  } else if (value.is_number()) {
    lua_pushnumber(lua, value.get<double>());
  } else if (value.is_boolean()) {
    lua_pushboolean(lua, value.get<bool>() ? 1 : 0);
  } else {
    lua_pushlightuserdata(lua, nullptr);
  }
}

}  // namespace inkcell::design
