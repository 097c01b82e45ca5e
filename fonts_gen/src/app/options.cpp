#include "app/options.hpp"

#include <charconv>
#include <map>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "program.hpp"
#include "source/named_sets.hpp"

namespace inkcell::gen {

using tools::take_one;

double parse_tolerance(const std::string& text) {
  std::string digits = text;
  const size_t slash = text.find('/');
  if (slash != std::string::npos && text.substr(slash) == "/255") {
    digits = text.substr(0, slash);
  }
  int value = 0;
  const char* end = digits.data() + digits.size();
  const auto [at, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc() || at != end || value < 1 || value > 255) {
    throw CLI::ValidationError("--tolerance",
                               "'" + text +
                                   "' is not within 1/255..255/255; write 16 "
                                   "or 16/255");
  }
  return value;
}

StrikeTarget parse_strike(const std::string& text) {
  StrikeTarget strike;
  const char* end = text.data() + text.size();
  const auto size = std::from_chars(text.data(), end, strike.px);
  const auto bits = size.ptr != end && *size.ptr == ':'
                        ? std::from_chars(size.ptr + 1, end, strike.bits)
                        : size;
  const std::string fit(bits.ptr, end);
  using Fit = format::StrikeFit;
  const std::map<std::string, Fit> fits = {{"", Fit::both},
                                           {":both", Fit::both},
                                           {":vertical", Fit::heights},
                                           {":none", Fit::none}};
  const bool is_known = fits.count(fit) != 0 && strike.px >= 4 &&
                        strike.px <= 255 &&
                        (strike.bits == 1 || strike.bits == 2 ||
                         (strike.bits == 4 && bits.ec == std::errc()));
  if (!is_known) {
    throw CLI::ValidationError(
        "--strike", "'" + text +
                        "' is not SIZE:BITS or SIZE:BITS:FIT; write 12:1, "
                        "with 4 to 255 px/em, 1, 2 or 4 bits, and none, "
                        "vertical or both");
  }
  strike.fit = fits.at(fit);
  if (strike.fit == Fit::heights && strike.bits < 4) {
    throw CLI::ValidationError(
        "--strike", "'" + text +
                        "': canvases of 1 and 2 bits fit both ways; write "
                        "both or none, or 4 bits");
  }
  return strike;
}

GlyphPart parse_part(const std::string& text) {
  GlyphPart part;
  const char* end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, part.number);
  const bool has_count =
      number.ec == std::errc() && number.ptr != end && *number.ptr == '/';
  const auto count = has_count
                         ? std::from_chars(number.ptr + 1, end, part.count)
                         : std::from_chars(end, end, part.count);
  if (count.ec != std::errc() || count.ptr != end || part.count > 1024 ||
      part.number >= part.count) {
    throw CLI::ValidationError("--part",
                               "'" + text +
                                   "' is no part; write 0/4 to 3/4, with "
                                   "up to 1024 parts");
  }
  return part;
}

namespace {

// An option with a few values, the default first.
template <typename Value>
void add_choice(CLI::App& app,
                const std::string& option,
                Value& target,
                const std::vector<std::pair<std::string, Value>>& values,
                const std::string& help) {
  std::string names;
  std::string quoted;
  for (size_t i = 0; i < values.size(); ++i) {
    names += (i == 0 ? "" : "|") + values[i].first;
    quoted += i == 0 ? "" : i + 1 == values.size() ? " or " : ", ";
    quoted += "'" + values[i].first + "'";
  }
  app.add_option_function<std::string>(
         option,
         [=, &target](const std::string& value) {
           for (const auto& [name, meaning] : values) {
             if (value == name) {
               target = meaning;
               return;
             }
           }
           throw CLI::ValidationError(
               option, "'" + value + "' is not known; use " + quoted);
         },
         help)
      ->type_name(names)
      ->default_str(values.front().first);
}

void add_selection(CLI::App& app, GenerateRequest& request) {
  app.add_option("--face", request.face, "Face number in a TTC or OTC file")
      ->type_name("INT")
      ->default_str("0");
  app.add_option("--instance", request.instance,
                 "Named instance of a variable font, such as Bold [the default "
                 "of the file]")
      ->type_name("NAME");
  take_one(app.add_option_function<std::vector<std::string>>(
               "--axis",
               [&request](const std::vector<std::string>& settings) {
                 for (const std::string& text : settings) {
                   try {
                     request.axes.push_back(parse_axis_range(text));
                   } catch (const Error& error) {
                     throw CLI::ValidationError("--axis", error.what());
                   }
                 }
               },
               "Axis of a variable font, such as wght=600: it moves away from "
               "the instance; repeatable. wght=300..800: each glyph gets a "
               "second master, into which it morphs"))
      ->type_name("TAG=VALUE|TAG=FROM..TO");
  take_one(app.add_option("--chars", request.chars,
                          "Characters: 0x20-0x7E,U+B0,176,A-Z,0-9; repeatable "
                          "[0x20-0x7E if no character is asked for]"))
      ->type_name("LIST");
  take_one(app.add_option("--set", request.sets,
                          "Named characters, such as latin-1,greek: " +
                              known_sets() + "; repeatable"))
      ->type_name("LIST");
  app.add_option("--symbols", request.symbols, "Characters, as themselves")
      ->check(CLI::Validator(
          [](const std::string& text) {
            return text.empty()
                       ? "it is empty; name characters, or leave it out"
                       : std::string();
          },
          ""))
      ->type_name("STRING");
  app.add_flag_callback(
      "--no-layout-glyphs", [&request] { request.layout_glyphs = false; },
      "Leave out '.' and '-', which layout needs for an ellipsis and for soft "
      "hyphens, and which text gets otherwise");
}

void add_quality(CLI::App& app, GenerateRequest& request) {
  Target& target = request.target;
  app.add_option("--min-px", target.min_px, "Smallest size [whole px/em]")
      ->type_name("INT")
      ->capture_default_str();
  app.add_option("--max-px", target.max_px, "Largest size [whole px/em]")
      ->type_name("INT")
      ->capture_default_str();
  app.add_option("--band-px", target.band_px,
                 "How far from the edge distances are good, at --min-px: for "
                 "outlines, shadows, glows [what filters need]");
  app.add_option_function<std::string>(
         "--tolerance",
         [&request](const std::string& text) {
           request.target.tolerance = parse_tolerance(text);
           request.tolerance_is_limit = true;
         },
         "Largest error of a pixel at any of these sizes: a glyph that misses "
         "it is an error; one that misses the default is drawn as well as "
         "possible, and a warning names it")
      ->type_name("N/255")
      ->default_str("16/255");
  // Options are evaluated in the order in which they are added.
  app.add_flag_callback(
      "--best-effort", [&request] { request.tolerance_is_limit = false; },
      "With --tolerance: a glyph that misses it is no error either");
  add_choice<Coding>(
      app, "--coding", target.coding,
      {{"outline", Coding::outline}, {"field", Coding::field}},
      "What glyphs are made of: 'outline', few points, for text; 'field', a "
      "quadtree of cells of the paper's nine distances, for the field at any "
      "point");
  add_choice<Predicate>(
      app, "--predicate", target.predicate,
      {{"size", Predicate::size_aware}, {"fixed", Predicate::fixed}},
      "What is good enough: 'size', the tolerance over the range of sizes; "
      "'fixed', 1/1024 em near the edge, for --coding field");
  add_choice<bool>(
      app, "--hints", request.hints, {{"on", true}, {"off", false}},
      "What grid fitting of outlines needs: zones, bars, stems and more");
  take_one(app.add_option("--morph", request.morphs,
                          "(outline) Characters whose outlines morph into "
                          "each other, each into each: 0123456789; groups are "
                          "parted by blanks: '01 12 23'; about 30 bytes a "
                          "pair; 'points:ab' pairs drawings point by point; "
                          "repeatable"))
      ->type_name("STRING");
  app.add_flag("--colour", request.has_colours,
               "(outline) Keep the colours of drawings and of colour fonts: "
               "ColourGlyphs draws them, other painters one colour");
  app.add_option("--shape", request.shapes,
                 "(outline) Scripts that the device shapes at run time, with "
                 "languages in capitals and further features: "
                 "arab:FAS,URD,hebr,thai,latn+smcp")
      ->type_name("LIST");
  app.add_flag("--keep-layout", request.keep_layout,
               "(outline) Keep GSUB, GPOS and GDEF, and all glyphs that they "
               "make of the characters, for HarfBuzz on the device "
               "(port/harfbuzz)");
  add_choice<bool>(
      app, "--compose", request.compose, {{"on", true}, {"off", false}},
      "(outline) What composes letters and marks (NFD) on the device, where "
      "the font has the composed letter and --shape is not given");
  app.add_option(
         "--paged", request.paged,
         "For storage that is not mapped, such as an SD card: blocks of "
         "so many bytes, which StoredFont reads")
      ->type_name("512|1024|2048|4096");
  take_one(app.add_option_function<std::vector<std::string>>(
               "--strike",
               [&request](const std::vector<std::string>& strikes) {
                 for (const std::string& text : strikes) {
                   request.strikes.push_back(parse_strike(text));
                 }
               },
               "Also pictures of all glyphs, which draw one size at a "
               "bitmap's cost: 12:1, or 16:4:vertical, is px/em, bits of a "
               "pixel (1, 2, 4), and what is fitted to pixels [both]; "
               "repeatable"))
      ->type_name("SIZE:BITS[:none|vertical|both]");
  app.add_flag("--strike-only", request.strike_only,
               "Pictures of the one --strike alone, without outlines: drawn "
               "at that size and whole multiples");
  app.add_option("--effort", target.effort,
                 "(field) How hard to try for fewer bytes; outlines have no "
                 "use for it")
      ->check(CLI::Range(0, 9).description(""))
      ->type_name("0..9")
      ->capture_default_str();
}

}  // namespace

void add_generator_options(CLI::App& app, GenerateRequest& request) {
  add_selection(app, request);
  add_quality(app, request);
}

}  // namespace inkcell::gen
