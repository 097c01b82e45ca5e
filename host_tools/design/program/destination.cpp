#include "program/destination.hpp"

#include "app/output.hpp"
#include "export/svg.hpp"
#include "import/outline_commands.hpp"
#include "journal/session.hpp"
#include "model/error.hpp"

namespace inkcell::design {

void add_destination(CLI::App& command, Destination& destination) {
  CLI::Option* out =
      command.add_option("--out", destination.out, "The picture to write")
          ->type_name("GLYPH.svg");
  CLI::Option* project = command
                             .add_option("--project", destination.project,
                                         "Or the project that has the glyph")
                             ->type_name("P.ufo")
                             ->excludes(out);
  CLI::Option* glyph =
      command
          .add_option("--glyph", destination.glyph,
                      "The glyph that gets the outline; a new one is added")
          ->type_name("NAME")
          ->needs(project);
  project->needs(glyph);
}

void check(const Destination& destination) {
  if (!destination.out.empty()) {
    gen::check_writable(destination.out);
  } else if (destination.project.empty()) {
    throw Error(
        "say with --out which picture to write, or with --project and --glyph "
        "which glyph gets the outline");
  }
}

std::string write(const gen::Outline& outline,
                  const Destination& destination,
                  const std::string& title) {
  if (!destination.out.empty()) {
    gen::OutputFile file(destination.out);
    file.write(svg_document(outline, title));
    file.commit();
    return destination.out;
  }
  UfoFiles files = read_ufo(destination.project);
  Player player(files.project);
  for (const Value& command :
       commands_for_outline(player.project(), destination.glyph, outline)) {
    player.play(command);
  }
  write_ufo(player.project(), destination.project, files);
  return destination.project + ", glyph '" + destination.glyph + "'";
}

}  // namespace inkcell::design
