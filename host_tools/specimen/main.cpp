// inkcell-specimen: specimen pictures of a font.
#include <CLI/CLI.hpp>

#include "compare.hpp"
#include "convert.hpp"
#include "files.hpp"
#include "program.hpp"
#include "specimen.hpp"
#include "star.hpp"
#include "styles.hpp"

namespace inkcell::tools {
namespace {

struct Arguments {
  gen::GenerateRequest request;
  std::string font;
  std::string sizes;
  std::string body;
  std::string digits;
  std::string turned;
  std::string moved;
  std::string filters;
  std::string lcd;
  std::string effects;
  std::string fitting;
  std::string contrast;
  std::string maps;
  std::string motion;
  std::string levels;
  std::string compare_body;
  std::string compare_display;
  std::string star;
  int width = 780;
};

constexpr const char* kPictures = "Pictures, one or more";
constexpr const char* kPicture = "OUT.png";

void add_arguments(CLI::App& app, Arguments& arguments) {
  app.add_option("FONT", arguments.font,
                 "ROM font, or TTF or OTF to convert in memory")
      ->required();
  const auto picture = [&app](const char* name, std::string& file,
                              const char* help) {
    app.add_option(std::string("--draw-") + name, file, help)
        ->type_name(kPicture)
        ->group(kPictures);
  };
  picture("sizes", arguments.sizes, "One line at ten sizes");
  app.add_option("--width", arguments.width, "Of the picture of sizes [px]")
      ->check(CLI::Range(300, 4096))
      ->capture_default_str()
      ->group(kPictures);
  picture("body", arguments.body, "Paragraphs at 11, 13 and 16 px");
  picture("digits", arguments.digits, "A clock, 160 px high");
  picture("turned", arguments.turned, "A word in many directions");
  picture("moved", arguments.moved, "A line moved by 1/8 px from row to row");
  picture("filters", arguments.filters, "Filters, weights, gamma");
  picture("lcd", arguments.lcd, "Sub-pixels");
  picture("effects", arguments.effects,
          "Outlines, shadows, glows: with --band-px 2 --min-px 12");
  picture("fitting", arguments.fitting, "Grid fitting, in grey and in 1 bit");
  picture("contrast", arguments.contrast,
          "Darker edges and thin strokes; for --coding field");
  picture("maps", arguments.maps, "Leaning, narrow, mirrored, turned");
  picture("motion", arguments.motion, "Motion blur");
  picture("levels", arguments.levels, "Displays of 1 and 2 bits");
  picture("compare-body", arguments.compare_body,
          "Text of 8 to 16 px beside that of others; FONT is a TTF or OTF");
  picture("compare-display", arguments.compare_display,
          "The same with letters of 40 px");
  picture("star", arguments.star, "A pattern finer than pixels");
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
  write(arguments.body, [&] { return draw_body(font); });
  write(arguments.digits, [&] { return draw_digits(font); });
  write(arguments.turned, [&] { return draw_turned(font); });
  write(arguments.moved, [&] { return draw_moved(font); });
  write(arguments.filters, [&] { return draw_filters(font); });
  write(arguments.lcd, [&] { return draw_lcd(font); });
  write(arguments.effects, [&] { return draw_effects(font); });
  write(arguments.fitting, [&] { return draw_fitting(font); });
  write(arguments.contrast, [&] { return draw_contrast(font); });
  write(arguments.maps, [&] { return draw_maps(font); });
  write(arguments.motion, [&] { return draw_motion(font); });
  write(arguments.levels, [&] { return draw_levels(font); });
  write(arguments.star, [&] { return draw_star(font); });
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
