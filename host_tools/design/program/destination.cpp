#include "program/destination.hpp"

#include <cmath>

#include "app/output.hpp"
#include "export/svg.hpp"
#include "journal/session.hpp"
#include "model/error.hpp"
#include "source/char_set.hpp"

namespace inkcell::design {
namespace {

std::string count_text(size_t count) {
  return std::to_string(count) + (count == 1 ? " contour" : " contours");
}

std::string change_text(const GlyphPointer& before,
                        const Glyph& after,
                        bool replaces) {
  const std::string name = "glyph '" + after.name + "'";
  if (before == nullptr) {
    const std::string code =
        after.unicodes.empty()
            ? "no code point, so that fonts leave it out (--unicode)"
            : gen::describe(after.unicodes.front());
    return "new " + name + ", " + code + ", advance " +
           std::to_string(std::lround(after.width));
  }
  return name + ", " +
         (replaces ? "in place of " + count_text(before->contours.size())
                   : "beside " + count_text(before->contours.size()) +
                         " (--replace removes them)");
}

}  // namespace

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
                      "The glyph to which the contours are added; a new one "
                      "if there is none of this name")
          ->type_name("NAME")
          ->needs(project);
  project->needs(glyph);
  command
      .add_flag("--replace", destination.use.replaces,
                "Remove the contours that the glyph has")
      ->needs(project);
  command
      .add_option("--unicode", destination.unicode,
                  "The character of a new glyph [what its name says: A, "
                  "exclam, uni2460]")
      ->type_name("U+0041")
      ->needs(project);
  command
      .add_option("--grid", destination.use.grid,
                  "Coordinates of the glyph are multiples of this; 0: not "
                  "rounded [font units]")
      ->check(CLI::Range(0.0, 100.0))
      ->capture_default_str()
      ->needs(project);
}

void check(Destination& destination) {
  if (!destination.out.empty()) {
    gen::check_writable(destination.out);
  } else if (destination.project.empty()) {
    throw Error(
        "say with --out which picture to write, or with --project and --glyph "
        "which glyph gets the outline");
  }
  if (!destination.unicode.empty()) {
    gen::CharSet characters;
    gen::add_ranges(destination.unicode, characters);
    if (characters.size() != 1) {
      throw Error("--unicode '" + destination.unicode +
                  "': a glyph has one character here; set_unicodes sets more");
    }
    destination.use.unicode = *characters.begin();
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
  const GlyphPointer before = files.project.find(destination.glyph);
  if (before != nullptr && destination.use.unicode) {
    throw Error("--unicode is for new glyphs; '" + destination.glyph +
                "' exists; use the command set_unicodes");
  }
  Player player(files.project);
  for (const Value& command : commands_for_outline(
           player.project(), destination.glyph, outline, destination.use)) {
    player.play(command);
  }
  write_ufo(player.project(), destination.project, files);
  return destination.project + ", " +
         change_text(before, *player.project().find(destination.glyph),
                     destination.use.replaces);
}

}  // namespace inkcell::design
