// inkcell-design stroke: the outline of a pen stroke.
#include <cstdio>
#include <memory>

#include "program/commands.hpp"
#include "program/destination.hpp"
#include "shape/shape.hpp"
#include "stroke/stroke.hpp"
#include "trace/field_outline.hpp"

namespace inkcell::design {
namespace {

struct StrokeArguments {
  std::string path;
  std::string nib = "ellipse:80,80,0";
  Destination destination;
  double path_tolerance = 0.5;
  double fit = 0.12;
};

void run(StrokeArguments& arguments) {
  check(arguments.destination);
  std::vector<std::vector<Point>> polygons;
  for (const Stroke& stroke :
       read_strokes(arguments.path, parse_nib(arguments.nib))) {
    for (std::vector<Point>& polygon :
         polygons_of(stroke, arguments.path_tolerance)) {
      polygons.push_back(std::move(polygon));
    }
  }
  const gen::Outline curves = fit_polygons(polygons, arguments.fit);
  const EdgeError error = edge_error(gen::Shape(outline_of_polygons(polygons)),
                                     gen::Shape(curves), 1);
  const std::string written = write(curves, arguments.destination,
                                    arguments.nib + " along " + arguments.path);
  std::printf(
      "%s: %zu contours, %zu segments, %.3f u from what the nib covers\n",
      written.c_str(), curves.contours.size(), segment_count(curves),
      error.worst);
}

}  // namespace

void add_stroke(CLI::App& app, Work& work) {
  auto arguments = std::make_shared<StrokeArguments>();
  CLI::App* command = app.add_subcommand(
      "stroke", "Draw a path with a pen: its outline as SVG or as a glyph");
  command
      ->add_option("--path", arguments->path,
                   "Points, x y [width [height [angle]]] on each line, in "
                   "1/1024 em and degrees; an empty line ends a stroke")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("--nib", arguments->nib,
                   "ellipse:WIDTH,HEIGHT,ANGLE or rectangle:WIDTH,HEIGHT,ANGLE")
      ->capture_default_str()
      ->type_name("NIB");
  add_destination(*command, arguments->destination);
  command
      ->add_option("--path-tolerance", arguments->path_tolerance,
                   "Bound on the distance of the path from its points "
                   "[1/1024 em]")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  command
      ->add_option("--fit", arguments->fit,
                   "Bound on the distance of curves from the pen's edge "
                   "[1/1024 em]")
      ->check(CLI::Range(0.05, 16.0))
      ->capture_default_str();
  command->callback(
      [arguments, &work] { work = [arguments] { run(*arguments); }; });
}

}  // namespace inkcell::design
