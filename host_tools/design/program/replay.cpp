// inkcell-design replay: runs a journal or a script.
#include <cstdio>
#include <memory>

#include "journal/session.hpp"
#include "model/error.hpp"
#include "program.hpp"
#include "program/commands.hpp"

namespace inkcell::design {
namespace {

namespace fs = std::filesystem;

struct ReplayArguments {
  std::string journal;
  std::vector<std::string> commands;
  std::string project;
  std::string out;
};

// The project of a journal is beside it.
fs::path project_of(const ReplayArguments& arguments,
                    const std::vector<Value>& records) {
  if (!arguments.project.empty()) {
    return arguments.project;
  }
  if (!records.empty() && records.front().value("do", "") == "begin") {
    return fs::path(arguments.journal).parent_path() /
           records.front().value("project", "");
  }
  return {};
}

// The records of the file, then those of the command line.
std::vector<Value> records_of(const ReplayArguments& arguments) {
  std::vector<Value> records;
  if (!arguments.journal.empty()) {
    records = read_script(arguments.journal);
  }
  for (const std::string& command : arguments.commands) {
    try {
      records.push_back(Value::parse(command));
    } catch (const Value::exception& error) {
      throw Error("--do '" + command + "': " + error.what());
    }
  }
  return records;
}

void replay(const ReplayArguments& arguments) {
  const std::vector<Value> records = records_of(arguments);
  const fs::path folder = project_of(arguments, records);
  UfoFiles files;
  if (!folder.empty()) {
    files = read_ufo(folder);
  }
  Player player(files.project);
  size_t done = 0;
  for (const Value& record : records) {
    try {
      player.play(record);
    } catch (const Error& error) {
      throw Error((arguments.journal.empty() ? "" : arguments.journal + ": ") +
                  "record " + std::to_string(done + 1) + " of " +
                  std::to_string(records.size()) + ": " + error.what());
    }
    ++done;
  }
  const fs::path out = arguments.out.empty() ? folder : fs::path(arguments.out);
  if (out.empty()) {
    throw Error("say with --out which project to write");
  }
  write_ufo(player.project(), out, files);
  std::printf("%zu records carried out, %s has %zu glyphs\n", done,
              out.string().c_str(), player.project().front().glyphs.size());
}

}  // namespace

void add_replay(CLI::App& app, Work& work) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command = app.add_subcommand(
      "replay", "Carry out the commands of a journal or of a script");
  command
      ->add_option("journal", arguments->journal,
                   "A journal, or a script: a command in JSON on each line")
      ->type_name("FILE");
  tools::take_one(command->add_option(
                      "--do", arguments->commands,
                      "A command in JSON, after those of the file; repeatable"))
      ->type_name("COMMAND");
  command
      ->add_option("--project", arguments->project,
                   "Begin with this project [the journal's; a script begins "
                   "with an empty one]")
      ->type_name("P.ufo");
  command
      ->add_option("--out", arguments->out,
                   "Where the result goes [the project itself]")
      ->type_name("P.ufo");
  command->callback(
      [arguments, &work] { work = [arguments] { replay(*arguments); }; });
}

}  // namespace inkcell::design
