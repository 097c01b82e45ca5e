// inkcell-design script: makes glyphs by a program in Lua.
#include <cstdio>
#include <memory>

#include "app/output.hpp"
#include "model/error.hpp"
#include "program.hpp"
#include "program/commands.hpp"
#include "script/lua_script.hpp"

namespace inkcell::design {
namespace {

namespace fs = std::filesystem;

struct ScriptArguments {
  std::string script;
  std::vector<std::string> settings;
  std::string project;
  std::string out;
  std::string commands;
  ScriptOptions options;
};

void run(ScriptArguments& arguments) {
  for (const std::string& text : arguments.settings) {
    add_setting(text, arguments.options);
  }
  const fs::path out =
      arguments.out.empty() ? arguments.project : arguments.out;
  if (out.empty()) {
    throw Error("say with --project or --out which project to write");
  }
  if (!arguments.commands.empty()) {
    gen::check_writable(arguments.commands);
  }
  UfoFiles files;
  if (!arguments.project.empty()) {
    files = read_ufo(arguments.project);
  }
  Player player(files.project);
  std::string lines;
  size_t done = 0;
  run_script(
      arguments.script, arguments.options,
      [&player]() -> const Project& { return player.project(); },
      [&](const Value& command) {
        player.play(command);
        lines += command.dump() + "\n";
        ++done;
      });
  write_ufo(player.project(), out, files);
  if (!arguments.commands.empty()) {
    gen::OutputFile file(arguments.commands);
    file.write(lines);
    file.commit();
  }
  std::printf("%zu commands carried out, %s has %zu glyphs\n", done,
              out.string().c_str(), player.project().front().glyphs.size());
}

}  // namespace

void add_script(CLI::App& app, Work& work) {
  auto arguments = std::make_shared<ScriptArguments>();
  CLI::App* command = app.add_subcommand(
      "script", "Make glyphs by a program in Lua, with pens and parameters");
  command->add_option("script", arguments->script, "The program")
      ->required()
      ->type_name("FILE.lua");
  tools::take_one(command->add_option("--set", arguments->settings,
                                      "A parameter of the program; repeatable"))
      ->type_name("NAME=NUMBER");
  command
      ->add_option("--project", arguments->project,
                   "Begin with this project [an empty one]")
      ->type_name("P.ufo");
  command
      ->add_option("--out", arguments->out,
                   "Where the result goes [the project itself]")
      ->type_name("P.ufo");
  command
      ->add_option("--commands", arguments->commands,
                   "Write the commands as well, for replay")
      ->type_name("FILE.jsonl");
  command
      ->add_option("--steps", arguments->options.most_steps,
                   "Instructions of Lua before the program is ended")
      ->check(CLI::Range(size_t{1000}, size_t{1} << 48))
      ->capture_default_str();
  command->add_flag("--trust", arguments->options.is_trusted,
                    "Give the program io, os and require: the files and "
                    "programs of this machine");
  command->callback(
      [arguments, &work] { work = [arguments] { run(*arguments); }; });
}

}  // namespace inkcell::design
