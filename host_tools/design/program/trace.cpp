// inkcell-design trace: from a bitmap master to curves.
#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/output.hpp"
#include "bitmap/edge_walk.hpp"
#include "bitmap/scan.hpp"
#include "fit/curve_fitter.hpp"
#include "model/error.hpp"
#include "program/commands.hpp"
#include "program/destination.hpp"

namespace inkcell::design {
namespace {

struct TraceArguments {
  std::string master;
  Destination destination;
  std::string report;
  MasterOptions options;
  std::vector<double> origin;
  std::vector<double> em;
  int threshold = 0;  // 0: automatic if is_scan, else greys are kept
  bool is_scan = false;
  bool no_extremes = false;
};

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count();
}

MasterPlace place_of(const TraceArguments& arguments, const Bitmap& bitmap) {
  if (!arguments.em.empty()) {
    return place_between({arguments.em[0], arguments.em[1]},
                         {arguments.em[2], arguments.em[3]});
  }
  if (arguments.options.place.px_per_em == 0) {
    throw Error("say with --px-per-em or with --em how large the master is");
  }
  MasterPlace place = arguments.options.place;
  place.origin_y = bitmap.height;
  if (!arguments.origin.empty()) {
    place.origin_x = arguments.origin[0];
    place.origin_y = arguments.origin[1];
  }
  return place;
}

void run(TraceArguments& arguments) {
  check(arguments.destination);
  if (!arguments.report.empty()) {
    gen::check_writable(arguments.report);
  }
  const auto begin = std::chrono::steady_clock::now();
  Bitmap bitmap = read_bitmap(arguments.master);
  MasterOptions& options = arguments.options;
  options.place = place_of(arguments, bitmap);
  options.extremes = !arguments.no_extremes;
  const double px_per_em = options.place.px_per_em;
  if (arguments.threshold != 0) {
    make_bilevel(bitmap, arguments.threshold);
  } else if (arguments.is_scan) {
    divide_scan(bitmap, options);
  }
  const gen::Outline curves = outline_of(bitmap, options);
  if (curves.contours.empty()) {
    throw Error(arguments.master +
                ": holds no ink; dark pixels are ink, and specks below "
                "--least-area are dropped");
  }
  const std::string written =
      write(curves, arguments.destination, arguments.master);
  const double seconds = seconds_since(begin);
  std::printf("%s: %zu contours, %zu segments, %.2f s\n", written.c_str(),
              curves.contours.size(), segment_count(curves), seconds);
  if (!arguments.report.empty()) {
    const nlohmann::json report = {
        {"master", arguments.master},
        {"px_per_em", px_per_em},
        {"bilevel", bitmap.is_bilevel()},
        {"contours", curves.contours.size()},
        {"segments", segment_count(curves)},
        {"tolerance_u", options.tolerance_u > 0
                            ? options.tolerance_u
                            : pixel_tolerance(bitmap, options.place)},
        {"seconds", seconds}};
    gen::OutputFile json(arguments.report);
    json.write(report.dump(2) + "\n");
    json.commit();
  }
}

}  // namespace

void add_trace(CLI::App& app, Work& work) {
  auto arguments = std::make_shared<TraceArguments>();
  CLI::App* command = app.add_subcommand(
      "trace",
      "Turn a bitmap master, of ink and none or of greys, into curves");
  command->add_option("--master", arguments->master, "A PNG; dark is ink")
      ->required()
      ->type_name("FILE.png");
  arguments->options.place.px_per_em = 0;
  CLI::Option* px_per_em =
      command
          ->add_option("--px-per-em", arguments->options.place.px_per_em,
                       "Pixels that an em is wide")
          ->check(CLI::Range(16.0, 65536.0));
  CLI::Option* origin =
      command
          ->add_option(
              "--origin", arguments->origin,
              "The glyph's origin, from the upper left corner [px]; the "
              "lower left corner if left out")
          ->expected(2)
          ->delimiter(',')
          ->type_name("X,Y");
  command
      ->add_option("--em", arguments->em,
                   "Instead of both: the origin, and the point of the baseline "
                   "an em to its right [px]; a slanting scan is turned")
      ->expected(4)
      ->delimiter(',')
      ->excludes(px_per_em)
      ->excludes(origin)
      ->type_name("X0,Y0,X1,Y1");
  add_destination(*command, arguments->destination);
  command
      ->add_option("--fit", arguments->options.tolerance_u,
                   "Bound on the distance of curves from the edge [1/1024 em; "
                   "what the pixels allow]")
      ->check(CLI::Range(0.02, 64.0));
  command
      ->add_option("--least-area", arguments->options.least_area_px,
                   "Specks and holes below this are dropped [px^2]")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  CLI::Option* scan =
      command->add_flag("--scan", arguments->is_scan,
                        "A scan: level its light, and divide its greys into "
                        "ink and paper (Otsu)");
  command
      ->add_option("--threshold", arguments->threshold,
                   "Ink is what is at least so dark, 1..255")
      ->check(CLI::Range(1, 255))
      ->excludes(scan);
  command->add_flag("--no-extremes", arguments->no_extremes,
                    "Do not insist on points at extremes");
  command->add_option("--report", arguments->report, "Write the report as JSON")
      ->type_name("R.json");
  command->callback(
      [arguments, &work] { work = [arguments] { run(*arguments); }; });
}

}  // namespace inkcell::design
