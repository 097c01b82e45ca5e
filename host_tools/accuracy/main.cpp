// inkcell-accuracy: how far the device's pixels are from the exact distance.
//
// A ROM font is drawn by the device's core; the truth is a brute-force distance
// to the outlines of the font file, computed apart from the generator.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <nlohmann/json.hpp>

#include "comparison.hpp"
#include "parallel.hpp"
#include "program.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {
namespace {

struct Arguments {
  std::string font;
  std::string truth;
  int face = 0;
  std::vector<double> sizes = {12, 16, 24, 32, 48, 64};
  std::vector<std::string> filters = {"text", "paper_display"};
  int phases = 4;
  double angle = 0;
  double limit = 16;
  double mean_limit = 1;
  unsigned jobs = 0;
  std::string json;
};

void add_arguments(CLI::App& app, Arguments& arguments) {
  app.add_option("--font", arguments.font, "ROM font")
      ->required()
      ->type_name("FILE.bin");
  app.add_option("--truth", arguments.truth, "The font file it was made of")
      ->required()
      ->type_name("FILE.ttf");
  app.add_option("--face", arguments.face, "Face number in a TTC or OTC file")
      ->capture_default_str();
  app.add_option("--px", arguments.sizes, "Sizes [px/em]")
      ->delimiter(',')
      ->type_name("LIST")
      ->default_str("12,16,24,32,48,64");
  app.add_option("--filters", arguments.filters, "Filters, by name")
      ->delimiter(',')
      ->type_name("LIST")
      ->default_str("text,paper_display");
  app.add_option("--phases", arguments.phases, "Sub-pixel positions")
      ->check(CLI::Range(1, kMaxPhases))
      ->capture_default_str();
  app.add_option("--angle", arguments.angle,
                 "Direction of the baseline, counter-clockwise [degrees]");
  app.add_option("--limit", arguments.limit,
                 "Largest error of a pixel with the filter text [1/255]")
      ->capture_default_str();
  app.add_option("--mean-limit", arguments.mean_limit,
                 "Largest mean error with the filter text [1/255]")
      ->capture_default_str();
  app.add_option("--jobs", arguments.jobs, "Threads [all cores]");
  app.add_option("--json", arguments.json, "Write the table as JSON")
      ->type_name("FILE");
}

ComparisonRequest make_request(const Arguments& arguments) {
  ComparisonRequest request;
  for (const double px : arguments.sizes) {
    // What the device can draw: whole 64ths.
    request.sizes.push_back(std::round(px * 64) / 64);
  }
  for (const std::string& name : arguments.filters) {
    request.filters.push_back(exact_filter(name));
  }
  request.phases = arguments.phases;
  request.angle = arguments.angle;
  return request;
}

ComparisonResults compare_all(const Font& font,
                              const TrueFont& truth,
                              const ComparisonRequest& request,
                              unsigned jobs) {
  const std::vector<Mapping> characters = mappings(font);
  ComparisonResults results(request.sizes.size() * request.filters.size());
  std::mutex guard;
  parallel_for(characters.size(), jobs, [&](size_t i) {
    const Mapping& character = characters[i];
    ComparisonResults own(results.size());
    compare_glyph(font, character.glyph, character.code_point,
                  truth.glyph(character.code_point), request, own);
    const std::lock_guard<std::mutex> lock(guard);
    for (size_t k = 0; k < own.size(); ++k) {
      results[k].add(own[k]);
    }
  });
  return results;
}

void print_row(double px, const ExactFilter& filter, const ErrorStatistics& e) {
  const ErrorPlace& at = e.worst_place();
  std::printf(
      "| %5g | %-13s | %5.1f | %5.3f | %5.2f | %s at (%d, %d), phase "
      "%d: %d for %.1f |\n",
      px, std::string(filter.device->name).c_str(), e.worst(), e.mean(),
      e.percentile(0.95), to_utf8(at.code_point).c_str(), at.x, at.y, at.phase,
      at.drawn, at.exact);
}

nlohmann::json to_json(double px,
                       const ExactFilter& filter,
                       const ErrorStatistics& e) {
  const ErrorPlace& at = e.worst_place();
  return {{"px", px},
          {"filter", std::string(filter.device->name)},
          {"max", e.worst()},
          {"mean", e.mean()},
          {"p95", e.percentile(0.95)},
          {"pixels", e.pixels()},
          {"worst",
           {{"char", to_utf8(at.code_point)},
            {"phase", at.phase},
            {"x", at.x},
            {"y", at.y},
            {"drawn", at.drawn},
            {"exact", at.exact}}}};
}

void write_json(const Arguments& arguments, const nlohmann::json& rows) {
  std::ofstream out(arguments.json);
  const nlohmann::json whole = {{"font", arguments.font},
                                {"truth", arguments.truth},
                                {"phases", arguments.phases},
                                {"angle", arguments.angle},
                                {"rows", rows}};
  out << whole.dump(2) << '\n';
  out.close();
  if (!out) {
    throw std::runtime_error(arguments.json + ": cannot be written");
  }
}

// Whether all sizes keep the limits.
bool run(const Arguments& arguments) {
  const RomFile rom = load_rom(arguments.font);
  const TrueFont truth(arguments.truth, arguments.face);
  const ComparisonRequest request = make_request(arguments);
  const ComparisonResults results =
      compare_all(rom.font(), truth, request, arguments.jobs);
  std::printf(
      "| px | filter | worst | mean | p95 | worst pixel |\n"
      "|---|---|---|---|---|---|\n");
  nlohmann::json rows = nlohmann::json::array();
  bool within = true;
  for (size_t f = 0; f < request.filters.size(); ++f) {
    const ExactFilter& filter = request.filters[f];
    for (size_t s = 0; s < request.sizes.size(); ++s) {
      const ErrorStatistics& e = results[s * request.filters.size() + f];
      print_row(request.sizes[s], filter, e);
      rows.push_back(to_json(request.sizes[s], filter, e));
      if (filter.device->name == "text") {
        within = within && e.worst() <= arguments.limit &&
                 e.mean() <= arguments.mean_limit;
      }
    }
  }
  if (!arguments.json.empty()) {
    write_json(arguments, rows);
  }
  if (!within) {
    std::printf("beyond the limit of %g worst, %g mean (filter text)\n",
                arguments.limit, arguments.mean_limit);
  }
  return within;
}

}  // namespace
}  // namespace inkcell::tools

int main(int argc, char** argv) {
  CLI::App app(
      "Errors of pixels drawn by the device's core, in 1/255, against the "
      "exact "
      "distance field.\nworst: over all pixels; mean: over glyph boxes and 1.5 "
      "px around them; p95: of the partly covered pixels.");
  inkcell::tools::Arguments arguments;
  inkcell::tools::add_arguments(app, arguments);
  return inkcell::tools::run_program(
      app, argc, argv, [&] { return inkcell::tools::run(arguments) ? 0 : 1; },
      2);
}
