#include "script/lua_script.hpp"

#include <cstdlib>
#include <fstream>
#include <memory>
#include <sstream>
#include <vector>

#include "model/commands.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "script/lua_value.hpp"
#include "script/pens.hpp"

namespace inkcell::design {
namespace {

// Lua is linked as C++: its errors are exceptions, and destructors run.

constexpr int kStepsBetweenLooks = 1000;

// The state of a run. Lua stores its address beside each of its states.
struct Run {
  const ScriptOptions* options = nullptr;
  const std::function<const Project&()>* project = nullptr;
  const std::function<void(const Value&)>* play = nullptr;
  std::string chunk;  // "@" and the file
  std::vector<ScriptParameter> parameters;
  size_t steps = 0;
  size_t bytes = 0;
};

Run& run_of(lua_State* lua) {
  return **static_cast<Run**>(lua_getextraspace(lua));
}

void* allocate(void* context, void* old, size_t old_size, size_t size) {
  Run& run = *static_cast<Run*>(context);
  const size_t before = old == nullptr ? 0 : old_size;
  if (size == 0) {
    std::free(old);
    run.bytes -= before;
    return nullptr;
  }
  if (size > before && run.bytes - before + size > run.options->most_bytes) {
    return nullptr;
  }
  void* fresh = std::realloc(old, size);
  if (fresh != nullptr) {
    run.bytes += size - before;
  }
  return fresh;
}

// Once the steps are used up, each further one fails: pcall() does not help.
void count_steps(lua_State* lua, lua_Debug*) {
  Run& run = run_of(lua);
  run.steps += kStepsBetweenLooks;
  if (run.steps > run.options->most_steps) {
    lua_sethook(lua, count_steps, LUA_MASKCOUNT, 1);
    luaL_error(lua,
               "the script takes more than %I steps; allow more with "
               "--steps if it is no endless loop",
               static_cast<LUAI_UACINT>(run.options->most_steps));
  }
}

// Runs `body`; exceptions become errors of Lua.
template <typename Body>
int guarded(lua_State* lua, const Body& body) {
  try {
    return body();
  } catch (const Error& error) {
    lua_pushstring(lua, error.what());
  } catch (const Value::exception& error) {
    lua_pushstring(lua, error.what());
  }
  return lua_error(lua);
}

int command(lua_State* lua) {
  return guarded(lua, [lua] {
    luaL_checktype(lua, 1, LUA_TTABLE);
    Value record = value_of(lua, 1);
    const char* name = lua_tostring(lua, lua_upvalueindex(1));
    if (record.is_array() && !record.empty()) {
      throw Error(std::string("command '") + name +
                  "': its arguments have names: " + name +
                  "{glyph = \"a\", ...}");
    }
    if (record.is_array()) {
      record = Value::object();
    }
    record["do"] = name;
    (*run_of(lua).play)(record);
    return 0;
  });
}

// param(name, otherwise [, least, most])
int param(lua_State* lua) {
  return guarded(lua, [lua] {
    Run& run = run_of(lua);
    const std::string name = luaL_checkstring(lua, 1);
    double value = luaL_checknumber(lua, 2);
    const auto set = run.options->settings.find(name);
    if (set != run.options->settings.end()) {
      value = set->second;
    }
    const double least = luaL_optnumber(lua, 3, value);
    const double most = luaL_optnumber(lua, 4, value);
    if (!(value >= least && value <= most)) {
      std::ostringstream text;
      text << "parameter '" << name << "' is " << value << "; it may be from "
           << least << " to " << most;
      throw Error(text.str());
    }
    run.parameters.push_back({name, value, least, most});
    lua_pushnumber(lua, value);
    return 1;
  });
}

// glyph(name): width, unicodes, contours and lib, as the commands take them.
int glyph(lua_State* lua) {
  return guarded(lua, [lua] {
    const GlyphPointer found =
        (*run_of(lua).project)().glyph(luaL_checkstring(lua, 1));
    Value result = {{"width", found->width},
                    {"unicodes", Value::array()},
                    {"contours", Value::array()},
                    {"lib", found->lib}};
    for (const char32_t code : found->unicodes) {
      result["unicodes"].push_back(static_cast<uint32_t>(code));
    }
    for (const PointContour& contour : found->contours) {
      result["contours"].push_back(contour_value(contour));
    }
    push_value(lua, result);
    return 1;
  });
}

int glyphs(lua_State* lua) {
  return guarded(lua, [lua] {
    push_value(lua, Value(glyph_order((*run_of(lua).project)())));
    return 1;
  });
}

void open_libraries(lua_State* lua, bool is_trusted) {
  if (is_trusted) {
    luaL_openlibs(lua);
    return;
  }
  const luaL_Reg safe[] = {
      {LUA_GNAME, luaopen_base},       {LUA_COLIBNAME, luaopen_coroutine},
      {LUA_TABLIBNAME, luaopen_table}, {LUA_STRLIBNAME, luaopen_string},
      {LUA_UTF8LIBNAME, luaopen_utf8}, {LUA_MATHLIBNAME, luaopen_math}};
  for (const luaL_Reg& library : safe) {
    luaL_requiref(lua, library.name, library.func, 1);
    lua_pop(lua, 1);
  }
  // Removed, as they read files or code that Lua does not check.
  for (const char* name : {"dofile", "loadfile", "load"}) {
    lua_pushnil(lua);
    lua_setglobal(lua, name);
  }
}

void add_functions(lua_State* lua) {
  lua_register(lua, "param", param);
  lua_register(lua, "glyph", glyph);
  lua_register(lua, "glyphs", glyphs);
  lua_pushlightuserdata(lua, nullptr);
  lua_setglobal(lua, "null");
  for (const std::string& name : command_names()) {
    lua_pushstring(lua, name.c_str());
    lua_pushcclosure(lua, command, 1);
    lua_setglobal(lua, name.c_str());
  }
  lua_getglobal(lua, "math");  // a script does the same each time
  lua_getfield(lua, -1, "randomseed");
  lua_pushinteger(lua, 1);
  lua_call(lua, 1, 0);
  lua_pop(lua, 1);
}

// Prefixes an error's text with the file and line of the script.
int add_place(lua_State* lua) {
  const Run& run = run_of(lua);
  const std::string file = run.chunk.substr(1);
  const char* found = luaL_tolstring(lua, 1, nullptr);
  std::string text = found;
  lua_Debug frame;
  for (int level = 0; lua_getstack(lua, level, &frame) != 0; ++level) {
    lua_getinfo(lua, "Sl", &frame);
    if (run.chunk != frame.source) {
      continue;
    }
    // Lua shortens long names in its own messages.
    const std::string own = std::string(frame.short_src) + ":" +
                            std::to_string(frame.currentline) + ": ";
    if (text.compare(0, own.size(), own) == 0) {
      text.erase(0, own.size());
    }
    text.insert(0, file + ":" + std::to_string(frame.currentline) + ": ");
    break;
  }
  lua_pushlstring(lua, text.data(), text.size());
  return 1;
}

void load_and_call(lua_State* lua,
                   const std::string& text,
                   const std::string& chunk) {
  lua_pushcfunction(lua, add_place);
  const int handler = lua_gettop(lua);
  int status =
      luaL_loadbufferx(lua, text.data(), text.size(), chunk.c_str(), "t");
  if (status == LUA_OK) {
    status = lua_pcall(lua, 0, 0, handler);
  }
  if (status == LUA_ERRMEM) {
    throw Error(chunk.substr(1) + ": needs more memory than its " +
                std::to_string(run_of(lua).options->most_bytes >> 20) + " MB");
  }
  if (status != LUA_OK) {
    const char* what = lua_tostring(lua, -1);
    throw Error(what != nullptr ? what : chunk.substr(1) + ": failed");
  }
  lua_settop(lua, 0);
}

std::string read_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf())) {
    throw Error(file.string() + ": cannot be read, or is empty");
  }
  return text.str();
}

void check_settings(const Run& run) {
  for (const auto& [name, value] : run.options->settings) {
    bool is_known = false;
    std::string names;
    for (const ScriptParameter& parameter : run.parameters) {
      is_known = is_known || parameter.name == name;
      names += (names.empty() ? "" : ", ") + parameter.name;
    }
    if (!is_known) {
      throw Error("--set " + name + ": " + run.chunk.substr(1) +
                  " has no such parameter; it has " +
                  (names.empty() ? "none" : names));
    }
  }
}

}  // namespace

std::vector<ScriptParameter> run_script(
    const std::filesystem::path& file,
    const ScriptOptions& options,
    const std::function<const Project&()>& project,
    const std::function<void(const Value& command)>& play) {
  const std::string text = read_text(file);
  Run run;
  run.options = &options;
  run.project = &project;
  run.play = &play;
  run.chunk = "@" + file.string();
  const std::unique_ptr<lua_State, void (*)(lua_State*)> state(
      lua_newstate(allocate, &run), lua_close);
  if (state == nullptr) {
    throw Error(file.string() + ": no memory for Lua");
  }
  lua_State* lua = state.get();
  *static_cast<Run**>(lua_getextraspace(lua)) = &run;
  // Protected: out of memory is an error like others.
  lua_pushcfunction(lua, [](lua_State* inner) {
    open_libraries(inner, run_of(inner).options->is_trusted);
    add_functions(inner);
    return 0;
  });
  if (lua_pcall(lua, 0, 0, 0) != LUA_OK) {
    throw Error(file.string() + ": " + lua_tostring(lua, -1));
  }
  load_and_call(lua, kPensScript, "@pens.lua");
  lua_sethook(lua, count_steps, LUA_MASKCOUNT, kStepsBetweenLooks);
  load_and_call(lua, text, run.chunk);
  check_settings(run);
  return run.parameters;
}

void add_setting(const std::string& text, ScriptOptions& options) {
  const size_t equals = text.find('=');
  try {
    if (equals != std::string::npos && equals != 0) {
      const std::string number = text.substr(equals + 1);
      size_t used = 0;
      const double value = std::stod(number, &used);
      if (used == number.size()) {
        options.settings[text.substr(0, equals)] = value;
        return;
      }
    }
  } catch (const std::logic_error&) {
    // the message below
  }
  throw Error("--set '" + text + "': write NAME=NUMBER, such as weight=80");
}

}  // namespace inkcell::design
