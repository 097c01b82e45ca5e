#include "editor/lua_run.hpp"

#include "editor/edits.hpp"
#include "journal/session.hpp"
#include "model/sources.hpp"

namespace inkcell::design::editor {
namespace {

// Instead of add_glyph where the glyph exists.
std::vector<Value> drawn_anew(const Glyph& glyph, const Value& command) {
  std::vector<Value> commands = {
      {{"do", "set_contours"}, {"contours", Value::array()}},
      {{"do", "set_advance"}, {"width", command.value("width", 0.0)}}};
  for (size_t i = glyph.components.size(); i-- > 0;) {
    commands.push_back({{"do", "delete_component"}, {"component", i}});
  }
  for (const char* key : {kStrokesKey, kOwnContoursKey, kTreeKey}) {
    commands.push_back({{"do", "set_glyph_lib"}, {"key", key}});
  }
  if (command.contains("unicodes")) {
    commands.push_back(
        {{"do", "set_unicodes"}, {"unicodes", command["unicodes"]}});
  }
  for (Value& each : commands) {
    each["glyph"] = glyph.name;
  }
  return commands;
}

}  // namespace

LuaRun run_lua(const Project& project,
               const std::filesystem::path& file,
               const std::map<std::string, double>& settings) {
  Player player(project);
  std::vector<Value> done;
  ScriptOptions options;
  options.settings = settings;
  LuaRun run;
  run.file = file;
  run.parameters = run_script(
      file, options, [&player]() -> const Project& { return player.project(); },
      [&](const Value& command) {
        std::vector<Value> commands = {command};
        if (command.value("do", "") == "add_glyph" &&
            command.contains("glyph") && command["glyph"].is_string()) {
          const GlyphPointer known =
              player.project().find(command["glyph"].get<std::string>());
          if (known != nullptr) {
            commands = drawn_anew(*known, command);
          }
        }
        for (Value& each : commands) {
          player.play(each);
          done.push_back(std::move(each));
        }
        ++run.commands;
      });
  run.command = {{"do", "batch"}, {"commands", done}};
  return run;
}

}  // namespace inkcell::design::editor
