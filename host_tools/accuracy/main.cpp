// inkcell-accuracy: the error of the device's pixels against exact areas and
// distances.
//
// The device's core draws a ROM font. The truth is the area of each pixel and a
// brute-force distance to the outlines of the font file, computed independently
// of the generator.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>

#include "comparison.hpp"
#include "files.hpp"
#include "parallel.hpp"
#include "pictures.hpp"
#include "program.hpp"
#include "progress.hpp"
#include "rom_file.hpp"
#include "size_list.hpp"
#include "table.hpp"

namespace inkcell::tools {
namespace {

struct Arguments {
  std::string font;
  std::string truth;
  int face = 0;
  std::vector<std::string> axes;
  std::vector<std::string> sizes = {"12", "16", "24", "32", "48", "64"};
  std::vector<std::string> filters;
  int phases = kMaxPhases;
  int positions = 0;
  uint32_t seed = 1;
  double angle = 0;
  std::string symbols;
  bool no_check = false;
  double mean_limit = std::numeric_limits<double>::infinity();
  size_t byte_limit = std::numeric_limits<size_t>::max();
  int threads = 0;
  std::string report;
  std::string picture;
  size_t worst = 8;
};

void add_arguments(CLI::App& app, Arguments& arguments) {
  app.add_option("--font", arguments.font, "ROM font")
      ->required()
      ->type_name("FILE");
  app.add_option("--truth", arguments.truth, "The font file it was made of")
      ->required()
      ->type_name("FILE");
  app.add_option("--face", arguments.face, "Face number in a TTC or OTC file")
      ->capture_default_str();
  take_one(
      app.add_option("--axis", arguments.axes,
                     "Axis of a variable font, as it was generated, such as "
                     "wght=600; repeatable"))
      ->type_name("TAG=VALUE");
  app.add_option("--sizes", arguments.sizes,
                 "Sizes and ranges of whole sizes, such as 8-64,80 [px/em]")
      ->delimiter(',')
      ->type_name("LIST")
      ->default_str("12,16,24,32,48,64");
  app.add_option("--filter", arguments.filters,
                 "Filters, by name, or all [area,text; of a field text]")
      ->delimiter(',')
      ->type_name("NAME");
  app.add_option("--phases", arguments.phases, "Fixed sub-pixel positions")
      ->check(CLI::Range(1, kMaxPhases))
      ->capture_default_str();
  app.add_option("--positions", arguments.positions,
                 "Instead of those so many random sub-pixel positions [1/64 "
                 "px], other ones for each glyph and size, and none that the "
                 "generator tries")
      ->check(CLI::Range(1, kMaxPositions))
      ->excludes("--phases");
  app.add_option("--seed", arguments.seed, "Which random positions")
      ->type_name("INT")
      ->needs("--positions")
      ->capture_default_str();
  app.add_option("--angle", arguments.angle,
                 "Direction of the baseline, counter-clockwise [degrees]");
  app.add_option("--symbols", arguments.symbols,
                 "Compare these characters only [all of the font]")
      ->type_name("STRING");
  app.add_flag("--no-check", arguments.no_check,
               "Exit with 0 even if a limit is missed: the font's tolerance "
               "at whole sizes of its range with the filter area, of a field "
               "text, and those that follow");
  app.add_option("--mean-limit", arguments.mean_limit,
                 "Exit with 2 if the mean is larger there [1/255; none]")
      ->check(CLI::Range(0.0, 255.0));
  app.add_option("--byte-limit", arguments.byte_limit,
                 "Exit with 2 if the font is larger [bytes; none]");
  app.add_option("--threads", arguments.threads, "Threads [all cores]")
      ->check(CLI::Range(0, 1024).description(""))
      ->type_name("INT");
  app.add_option("--report", arguments.report, "Write the table as JSON")
      ->type_name("FILE");
  app.add_option("--picture", arguments.picture,
                 "Draw the worst glyphs: drawn, exact, difference")
      ->type_name("FILE.png");
  app.add_option("--worst", arguments.worst, "How many to draw")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
}

// Fields have distances only.
bool has_areas(const Font& font) {
  return coding_name(font) == "outline";
}

// The filter that the font's tolerance is about.
std::string_view promised_filter(const Font& font) {
  return has_areas(font) ? "area" : "text";
}

ComparisonRequest make_request(const Font& font, const Arguments& arguments) {
  ComparisonRequest request;
  request.sizes = read_sizes(arguments.sizes);
  std::vector<std::string> names = arguments.filters;
  if (names.empty()) {
    names = has_areas(font) ? std::vector<std::string>{"area", "text"}
                            : std::vector<std::string>{"text"};
  }
  for (const std::string& name : names) {
    if (name != "all") {
      request.filters.push_back(exact_filter(name));
      continue;
    }
    if (has_areas(font)) {
      request.filters.push_back(exact_filter("area"));
    }
    for (const NamedFilter& filter : kFilters) {
      request.filters.push_back(exact_filter(filter.name));
    }
  }
  request.phases = arguments.phases;
  request.positions = arguments.positions;
  request.seed = arguments.seed;
  request.angle = arguments.angle;
  return request;
}

// Positions at each size.
int positions_of(const Arguments& arguments) {
  return arguments.positions != 0 ? arguments.positions : arguments.phases;
}

std::vector<Mapping> choose_characters(const Font& font,
                                       const std::string& wanted) {
  if (wanted.empty()) {
    return mappings(font);
  }
  std::vector<Mapping> characters;
  for (const char32_t c : from_utf8(wanted)) {
    uint16_t glyph = 0;
    if (font.glyph_of(c, glyph) != Status::ok) {
      throw std::runtime_error("the font has no glyph for '" + to_utf8(c) +
                               "'");
    }
    characters.push_back({c, glyph});
  }
  return characters;
}

ErrorTable compare_all(const Font& font,
                       const TrueFont& truth,
                       const Arguments& arguments) {
  ErrorTable table;
  table.request = make_request(font, arguments);
  table.characters = choose_characters(font, arguments.symbols);
  const size_t count = table.characters.size();
  table.errors.resize(count);
  Progress bar(!Progress::is_terminal());
  std::mutex guard;
  size_t done = 0;
  parallel_for(count, arguments.threads, [&](size_t i) {
    const Mapping& character = table.characters[i];
    const TrueGlyph glyph = truth.glyph(character.code_point);
    table.errors[i] = compare_glyph(
        {font, character.glyph, character.code_point, glyph}, table.request);
    const std::lock_guard<std::mutex> lock(guard);
    bar.update(++done, count);
  });
  return table;
}

void write_json(const Arguments& arguments,
                const Font& font,
                const ErrorTable& table) {
  std::ofstream out(arguments.report);
  const nlohmann::json whole = {{"font", arguments.font},
                                {"font_bytes", font.rom().size},
                                {"coding", coding_name(font)},
                                {"truth", arguments.truth},
                                {"characters", table.characters.size()},
                                {"positions", positions_of(arguments)},
                                {"angle", arguments.angle},
                                {"rows", table_as_json(table)}};
  out << whole.dump(2) << '\n';
  out.close();
  if (!out) {
    throw std::runtime_error(arguments.report + ": cannot be written");
  }
}

void write_picture(const Arguments& arguments,
                   const Font& font,
                   const TrueFont& truth,
                   const ErrorTable& table) {
  std::vector<Exhibit> exhibits;
  for (const WorstOfGlyph& worst : worst_glyphs(table, arguments.worst)) {
    const Mapping& character = table.characters[worst.character];
    const TrueGlyph glyph = truth.glyph(character.code_point);
    const double px = table.request.sizes[worst.size];
    exhibits.push_back(
        {draw_picture({font, character.glyph, character.code_point, glyph},
                      table.request.filters[worst.filter], px, arguments.angle,
                      worst.place.offset),
         table.request.filters[worst.filter].device->name, px, worst.place});
  }
  write_image(arguments.picture, draw_exhibits(font, exhibits));
}

// Whether the promised filter keeps the limits at integer sizes in the font's
// range; prints where it does not.
bool check(const Font& font, const ErrorTable& table, double mean_limit) {
  const FontRange range = font.range();
  const ComparisonRequest& request = table.request;
  bool within = true;
  for (size_t f = 0; f < request.filters.size(); ++f) {
    for (size_t s = 0; s < request.sizes.size(); ++s) {
      const double px = request.sizes[s];
      const bool promised =
          request.filters[f].device->name == promised_filter(font) &&
          px == std::floor(px) && px >= range.min_px && px <= range.max_px;
      if (!promised) {
        continue;
      }
      const ErrorSummary errors = table.summary(s, f);
      // The paper's predicate has no limit of coverage: its tolerance is 0.
      if (range.tolerance != 0 && errors.worst() > range.tolerance) {
        std::printf("%g px: beyond the font's tolerance of %d/255\n", px,
                    range.tolerance);
        within = false;
      }
      if (!(errors.mean() <= mean_limit)) {
        std::printf("%g px: the mean is beyond %g/255\n", px, mean_limit);
        within = false;
      }
    }
  }
  return within;
}

// Comparing takes minutes: checks outputs before.
void check_outputs(const Arguments& arguments) {
  check_apart({arguments.report, arguments.picture},
              {arguments.font, arguments.truth});
  check_folder_of(arguments.report);
  if (!arguments.picture.empty()) {
    check_image_file(arguments.picture, 3);  // in colour
  }
}

int run(const Arguments& arguments) {
  check_outputs(arguments);
  const RomFile rom = load_rom(arguments.font);
  const Font& font = rom.font();
  const TrueFont truth(arguments.truth, arguments.face, arguments.axes);
  const ErrorTable table = compare_all(font, truth, arguments);
  print_table(table);
  std::printf(
      "%zu characters, %d positions a size; the font has %zu bytes, coding "
      "%s\n",
      table.characters.size(), positions_of(arguments), font.rom().size,
      std::string(coding_name(font)).c_str());
  if (!arguments.report.empty()) {
    write_json(arguments, font, table);
  }
  if (!arguments.picture.empty()) {
    write_picture(arguments, font, truth, table);
  }
  bool within = check(font, table, arguments.mean_limit);
  if (font.rom().size > arguments.byte_limit) {
    std::printf("the font has more than %zu bytes\n", arguments.byte_limit);
    within = false;
  }
  return within || arguments.no_check ? 0 : kMissed;
}

}  // namespace
}  // namespace inkcell::tools

int main(int argc, char** argv) {
  CLI::App app(
      "Errors of pixels drawn by the device's core, in 1/255, against exact "
      "areas and distances.\nworst: over all pixels; mean: over the glyph's "
      "box and 1.5 px around it, then over the glyphs;\nlargest mean: of a "
      "single glyph, which is named.\nExits with 2 if a limit is missed.");
  inkcell::tools::Arguments arguments;
  inkcell::tools::add_arguments(app, arguments);
  return inkcell::tools::run_program(
      app, argc, argv, [&] { return inkcell::tools::run(arguments); });
}
