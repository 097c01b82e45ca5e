// inkcell-design export and import: converts projects to fonts and back.
#include <cstdio>
#include <memory>
#include <optional>

#include "app/options.hpp"
#include "app/output.hpp"
#include "export/designspace.hpp"
#include "export/rom.hpp"
#include "export/svg.hpp"
#include "export/ttf.hpp"
#include "import/font_import.hpp"
#include "model/contours.hpp"
#include "model/error.hpp"
#include "program.hpp"
#include "program/commands.hpp"
#include "progress.hpp"
#include "ufo/ufo.hpp"

namespace inkcell::design {
namespace {

namespace fs = std::filesystem;

struct ConvertArguments {
  std::string project;
  std::string out;
  std::string glyph;
  std::string font;
  bool decompose = false;
  gen::GenerateRequest request;
};

void say_warnings(const gen::Warnings& warnings) {
  for (const gen::Warning& warning : warnings) {
    std::fprintf(stderr, "%s\n", warning.message().c_str());
  }
}

void export_rom(const Project& project,
                ConvertArguments& arguments,
                TtfReport& report) {
  std::optional<tools::Progress> progress(false);
  arguments.request.progress = [&progress](size_t done, size_t count) {
    progress->update(done, count);
  };
  const gen::RomFont font = make_rom(project, arguments.request, &report);
  progress.reset();
  say_warnings(font.warnings);
  write_bytes(arguments.out, font.bytes);
}

void run_export(ConvertArguments& arguments) {
  UfoFiles files = read_ufo(arguments.project);
  const Project& project = files.project;
  const std::string ending = fs::path(arguments.out).extension().string();
  if (ending == ".ufo") {
    write_ufo(project, arguments.out, files);
    return;
  }
  gen::check_writable(arguments.out);
  TtfReport report;
  if (ending == ".ttf") {
    write_bytes(arguments.out, write_ttf(project, &report));
  } else if (ending == ".bin") {
    export_rom(project, arguments, report);
  } else if (ending == ".designspace") {
    write_designspace(project, arguments.out);
  } else if (ending == ".svg") {
    if (arguments.glyph.empty()) {
      throw Error("say with --glyph which glyph to draw");
    }
    gen::OutputFile file(arguments.out);
    file.write(svg_document(
        outline_of(project, *project.glyph(arguments.glyph)), arguments.glyph));
    file.commit();
  } else {
    throw Error(
        arguments.out +
        ": its ending says what to write: .ttf, .bin, .ufo, .designspace or "
        ".svg");
  }
  std::printf("%s: %ju bytes", arguments.out.c_str(),
              static_cast<uintmax_t>(fs::file_size(arguments.out)));
  if (report.glyphs != 0) {
    std::printf(", %s", report.text().c_str());
  }
  std::printf("\n");
}

void run_import(const ConvertArguments& arguments) {
  gen::Warnings warnings;
  const std::string text = import_project(
      arguments.font, arguments.out, arguments.request.chars, warnings,
      arguments.decompose ? Composites::decompose : Composites::keep);
  say_warnings(warnings);
  std::printf("%s: %s\n", arguments.out.c_str(), text.c_str());
}

}  // namespace

void add_export(CLI::App& app, Work& work) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command = app.add_subcommand(
      "export", "Write a project as a font, or a glyph of it as a picture");
  command->add_option("--project", arguments->project, "The project")
      ->required()
      ->type_name("P.ufo");
  command
      ->add_option("--out", arguments->out,
                   "What to write: TrueType, an Inkcell font, a UFO, the "
                   "sources of a variable font, or SVG")
      ->required()
      ->type_name("FONT.ttf|FONT.bin|Q.ufo|Q.designspace|GLYPH.svg");
  command->add_option("--glyph", arguments->glyph, "The glyph, for SVG")
      ->type_name("NAME");
  gen::add_generator_options(*command, arguments->request);
  command->callback(
      [arguments, &work] { work = [arguments] { run_export(*arguments); }; });
}

void add_import(CLI::App& app, Work& work) {
  auto arguments = std::make_shared<ConvertArguments>();
  CLI::App* command =
      app.add_subcommand("import", "Make a project of a font file");
  command->add_option("--font", arguments->font, "TTF or OTF")
      ->required()
      ->type_name("FILE");
  tools::take_one(
      command->add_option("--chars", arguments->request.chars,
                          "Characters: 0x20-0x7E,U+B0,A-Z; repeatable [all]"))
      ->type_name("LIST");
  command->add_flag("--decompose", arguments->decompose,
                    "Contours in the place of components");
  command->add_option("--out", arguments->out, "The project, a new folder")
      ->required()
      ->type_name("P.ufo");
  command->callback(
      [arguments, &work] { work = [arguments] { run_import(*arguments); }; });
}

}  // namespace inkcell::design
