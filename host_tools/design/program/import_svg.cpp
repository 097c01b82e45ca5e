// inkcell-design import-svg: imports paths of another program as a glyph.
#include <cstdio>
#include <memory>

#include "fit/curve_fitter.hpp"
#include "import/svg_import.hpp"
#include "program/commands.hpp"
#include "program/destination.hpp"

namespace inkcell::design {
namespace {

struct ImportSvgArguments {
  std::string drawing;
  DrawingPlace place;
  std::vector<double> origin;
  Destination destination;
};

void run(ImportSvgArguments& arguments) {
  check(arguments.destination);
  if (!arguments.origin.empty()) {
    arguments.place.origin = {arguments.origin[0], arguments.origin[1]};
  }
  const gen::Outline outline = read_svg(arguments.drawing, arguments.place);
  const std::string written =
      write(outline, arguments.destination, arguments.drawing);
  std::printf("%s: %zu contours, %zu segments\n", written.c_str(),
              outline.contours.size(), segment_count(outline));
}

}  // namespace

void add_import_svg(CLI::App& app, Work& work) {
  auto arguments = std::make_shared<ImportSvgArguments>();
  CLI::App* command = app.add_subcommand(
      "import-svg", "Make a drawing of one colour, an SVG file, a glyph");
  command->add_option("--drawing", arguments->drawing, "The SVG file")
      ->required()
      ->type_name("FILE.svg");
  command
      ->add_option("--px-per-em", arguments->place.px_per_em,
                   "User units that an em is wide")
      ->check(CLI::Range(0.001, 1e6))
      ->capture_default_str();
  command
      ->add_option("--origin", arguments->origin,
                   "The glyph's origin in user units, y down [0,0]")
      ->expected(2)
      ->delimiter(',')
      ->type_name("X,Y");
  add_destination(*command, arguments->destination);
  command->callback(
      [arguments, &work] { work = [arguments] { run(*arguments); }; });
}

}  // namespace inkcell::design
