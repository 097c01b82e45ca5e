// inkcell-inspect: the content of a font as text, JSON and pictures.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>

#include "census.hpp"
#include "convert.hpp"
#include "files.hpp"
#include "pictures.hpp"
#include "program.hpp"
#include "report.hpp"
#include "runs.hpp"

namespace inkcell::tools {
namespace {

struct Arguments {
  gen::GenerateRequest request;
  std::string file;
  std::string glyph;
  std::string cells;
  std::string points;
  std::string field;
  std::string sheet;
  std::string run_file;
  int side = 1000;
  double px = 32;
  bool json = false;
};

void add_arguments(CLI::App& app, Arguments& arguments) {
  add_conversion_options(app, arguments.request);
  app.add_option("FILE", arguments.file,
                 "ROM font, or TTF, OTF, WOFF or WOFF2 to convert in memory")
      ->required();
  app.add_option("--glyph", arguments.glyph,
                 "Look at one glyph: a character, or #17 for an id")
      ->type_name("CHAR");
  app.add_option("--cells", arguments.cells,
                 "Draw the glyph's field and cells [glyph a, or the first]; "
                 "for --coding field")
      ->type_name("OUT.png");
  app.add_option("--points", arguments.points,
                 "Draw the glyph's contours and points: corners (squares), "
                 "smooth (discs), off the curve (rings); with its hints: zones "
                 "(dashed), bars (red), serifs (orange), lone edges (purple), "
                 "free ends (blue), stems (green); for --coding outline")
      ->type_name("OUT.png");
  app.add_option("--field", arguments.field,
                 "Draw the glyph's field, as the device has it")
      ->type_name("OUT.png");
  app.add_option("--side", arguments.side, "Longer side of these pictures [px]")
      ->check(CLI::Range(64, 16384))
      ->capture_default_str();
  app.add_option("--sheet", arguments.sheet, "Draw all glyphs")
      ->type_name("OUT.png");
  app.add_option("--run-file", arguments.run_file,
                 "Shape each line of a file as the device does, and print the "
                 "glyphs of each as a line of JSON, from left to right; for "
                 "fonts made with --shape")
      ->type_name("WORDS.txt");
  app.add_option("--px", arguments.px, "Size on the sheet [px/em]")
      ->capture_default_str();
  app.add_flag("--json", arguments.json, "Print JSON instead of text");
}

const GlyphCensus& glyph_by_id(const FontCensus& font, const std::string& id) {
  char* end = nullptr;
  const unsigned long number = std::strtoul(id.c_str(), &end, 10);
  if (*end != '\0' || number >= font.glyphs.size()) {
    throw std::runtime_error("glyph ids go from #0 to #" +
                             std::to_string(font.glyphs.size() - 1));
  }
  return font.glyphs[number];
}

const GlyphCensus& find_glyph(const FontCensus& font, const std::string& name) {
  const std::vector<char32_t> characters = from_utf8(name);
  if (characters.size() > 1 && name[0] == '#') {
    return glyph_by_id(font, name.substr(1));
  }
  if (characters.size() != 1) {
    throw std::runtime_error("--glyph takes one character, or #17 for an id");
  }
  for (const GlyphCensus& glyph : font.glyphs) {
    for (const char32_t code_point : glyph.code_points) {
      if (code_point == characters[0]) {
        return glyph;
      }
    }
  }
  throw std::runtime_error("the font has no glyph for '" + name + "'");
}

// The glyph of a picture if none was named: a, or the first with ink.
const GlyphCensus& example_glyph(const FontCensus& font) {
  const GlyphCensus* first = nullptr;
  for (const GlyphCensus& glyph : font.glyphs) {
    if (glyph.has_ink()) {
      if (glyph.name() == "a") {
        return glyph;
      }
      first = first == nullptr && glyph.glyph != 0 ? &glyph : first;
    }
  }
  return first == nullptr ? font.glyphs.front() : *first;
}

// False: the font is damaged.
bool run(const Arguments& arguments, const CLI::App& app) {
  check_apart(
      {arguments.cells, arguments.points, arguments.field, arguments.sheet},
      {arguments.file});
  const RomFile rom = load_font_file(
      arguments.file, conversion_of(app, arguments.request),
      arguments.glyph.size() > 1 && arguments.glyph[0] == '#' ? std::string()
                                                              : arguments.glyph,
      Damaged::shown);
  if (!arguments.run_file.empty()) {
    print_runs(rom.font(), arguments.run_file);
    return true;
  }
  const FontCensus font = take_census(rom.font());
  const GlyphCensus* glyph =
      arguments.glyph.empty() ? nullptr : &find_glyph(font, arguments.glyph);
  const GlyphCensus& shown = glyph != nullptr ? *glyph : example_glyph(font);
  const auto write = [](const std::string& file, const auto& draw) {
    if (!file.empty()) {
      write_image(file, draw());
    }
  };
  const int side = arguments.side;
  write(arguments.cells, [&] { return draw_cells(rom.font(), shown, side); });
  write(arguments.points,
        [&] { return draw_points(font, rom.font(), shown, side); });
  write(arguments.field, [&] { return draw_field(rom.font(), shown, side); });
  write(arguments.sheet, [&] { return draw_sheet(rom.font(), arguments.px); });
  const std::string report = arguments.json     ? json_report(font, glyph)
                             : glyph != nullptr ? glyph_report(font, *glyph)
                                                : font_report(font);
  std::fputs(report.c_str(), stdout);
  if (font.verified != Status::ok) {
    std::fprintf(stderr, "error: %s: it is damaged; regenerate it\n",
                 arguments.file.c_str());
  }
  return font.verified == Status::ok;
}

}  // namespace
}  // namespace inkcell::tools

int main(int argc, char** argv) {
  CLI::App app("Shows what is in an Inkcell font.");
  inkcell::tools::Arguments arguments;
  inkcell::tools::add_arguments(app, arguments);
  return inkcell::tools::run_program(app, argc, argv, [&] {
    return inkcell::tools::run(arguments, app) ? 0 : 1;
  });
}
