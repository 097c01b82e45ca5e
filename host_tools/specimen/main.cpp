// inkcell-specimen: specimen pictures of a font.
#include <CLI/CLI.hpp>
#include <array>
#include <iterator>

#include "compare.hpp"
#include "convert.hpp"
#include "files.hpp"
#include "program.hpp"
#include "specimen.hpp"
#include "star.hpp"
#include "styles.hpp"

namespace inkcell::tools {
namespace {

// A picture that needs a font alone.
struct Picture {
  const char* name;
  const char* help;
  Image (*draw)(const Font& font);
};
constexpr Picture kPictures[] = {
    {"body", "Paragraphs at 11, 13 and 16 px", draw_body},
    {"digits", "A clock, 160 px high", draw_digits},
    {"turned", "A word in many directions", draw_turned},
    {"moved", "A line moved by 1/8 px from row to row", draw_moved},
    {"filters", "Filters, weights, gamma", draw_filters},
    {"lcd", "Sub-pixels", draw_lcd},
    {"effects", "Outlines, shadows, glows: with --band-px 2 --min-px 12",
     draw_effects},
    {"fitting", "Grid fitting, in grey and in 1 bit", draw_fitting},
    {"contrast", "Darker edges and thin strokes; for --coding field",
     draw_contrast},
    {"maps", "Leaning, narrow, mirrored, turned", draw_maps},
    {"motion", "Motion blur", draw_motion},
    {"levels", "Displays of 1 and 2 bits", draw_levels},
    {"star", "A pattern finer than pixels", draw_star}};

struct Arguments {
  gen::GenerateRequest request;
  std::string font;
  std::string sizes;
  std::array<std::string, std::size(kPictures)> pictures;
  std::string compare_body;
  std::string compare_display;
  int width = 780;
};

constexpr const char* kGroup = "Pictures, one or more";
constexpr const char* kPicture = "OUT.png";

void add_arguments(CLI::App& app, Arguments& arguments) {
  app.add_option("FONT", arguments.font,
                 "ROM font, or TTF or OTF to convert in memory")
      ->required();
  const auto picture = [&app](const char* name, std::string& file,
                              const char* help) {
    app.add_option(std::string("--draw-") + name, file, help)
        ->type_name(kPicture)
        ->group(kGroup);
  };
  picture("sizes", arguments.sizes, "One line at ten sizes");
  app.add_option("--width", arguments.width, "Of the picture of sizes [px]")
      ->check(CLI::Range(300, 4096))
      ->capture_default_str()
      ->group(kGroup);
  for (size_t i = 0; i < arguments.pictures.size(); ++i) {
    picture(kPictures[i].name, arguments.pictures[i], kPictures[i].help);
  }
  picture("compare-body", arguments.compare_body,
          "Text of 8 to 16 px beside that of others; FONT is a TTF or OTF");
  picture("compare-display", arguments.compare_display,
          "The same with letters of 40 px");
  add_conversion_options(app, arguments.request);
}

bool has_comparison(const Arguments& arguments) {
  return !arguments.compare_body.empty() || !arguments.compare_display.empty();
}

// Checks arguments before a font is converted, which takes seconds.
void check(const Arguments& arguments, const CLI::App& app) {
  const std::vector<const CLI::Option*> given =
      app.get_options([](const CLI::Option* option) {
        return option->get_type_name() == kPicture && option->count() > 0;
      });
  if (given.empty()) {
    throw std::runtime_error("no picture is asked for; see --help");
  }
  std::vector<std::filesystem::path> pictures;
  for (const CLI::Option* option : given) {
    pictures.emplace_back(option->results().front());
  }
  check_apart(pictures, {arguments.font});
  if (has_comparison(arguments) && is_rom_font(read_file(arguments.font))) {
    throw std::runtime_error(
        arguments.font +
        ": is a ROM font; others cannot draw it: name a TTF or OTF");
  }
}

void run(const Arguments& arguments, const CLI::App& app) {
  check(arguments, app);
  const RomFile rom =
      load_font_file(arguments.font, conversion_of(app, arguments.request), "");
  const auto write = [](const std::string& file, const auto& draw) {
    if (!file.empty()) {
      write_image(file, draw());
    }
  };
  const Font& font = rom.font();
  write(arguments.sizes, [&] { return draw_sizes(font, arguments.width); });
  for (size_t i = 0; i < arguments.pictures.size(); ++i) {
    write(arguments.pictures[i], [&] { return kPictures[i].draw(font); });
  }
  if (has_comparison(arguments)) {
    PeerFont peers(arguments.font);
    write(arguments.compare_body, [&] { return compare_body(font, peers); });
    write(arguments.compare_display,
          [&] { return compare_display(font, peers); });
  }
}

}  // namespace
}  // namespace inkcell::tools

int main(int argc, char** argv) {
  CLI::App app("Draws pictures that show an Inkcell font at work.");
  inkcell::tools::Arguments arguments;
  inkcell::tools::add_arguments(app, arguments);
  return inkcell::tools::run_program(app, argc, argv, [&] {
    inkcell::tools::run(arguments, app);
    return 0;
  });
}
