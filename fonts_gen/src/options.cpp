#include "options.hpp"

#include <charconv>

namespace inkcell::gen {
namespace {

// Reads "16/255" or "16".
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

// An option of which this version knows only one value.
void add_fixed_choice(CLI::App& app,
                      const std::string& option,
                      const std::string& known,
                      const std::string& later,
                      const std::string& help) {
  app.add_option_function<std::string>(
         option,
         [=](const std::string& value) {
           if (value == later) {
             throw CLI::ValidationError(
                 option, "'" + later +
                             "' is not available in this version; use '" +
                             known + "'");
           }
           if (value != known) {
             throw CLI::ValidationError(
                 option, "'" + value + "' is not known; use '" + known + "'");
           }
         },
         help)
      ->type_name(known)
      ->default_str(known);
}

void add_selection(CLI::App& app, GenerateRequest& request) {
  app.add_option("--face", request.face, "Face number in a TTC or OTC file")
      ->capture_default_str();
  app.add_option_function<std::vector<std::string>>(
         "--axis",
         [&request](const std::vector<std::string>& settings) {
           for (const std::string& text : settings) {
             try {
               request.axes.push_back(parse_axis(text));
             } catch (const Error& error) {
               throw CLI::ValidationError(error.what());
             }
           }
         },
         "Axis of a variable font, such as wght=600; repeatable")
      ->type_name("TAG=VALUE")
      ->allow_extra_args(false);
  app.add_option("--chars", request.chars,
                 "Characters: 0x20-0x7E,U+B0,176,A-Z; repeatable "
                 "[0x20-0x7E if no character is asked for]")
      ->type_name("LIST")
      ->allow_extra_args(false);
  app.add_option("--symbols", request.symbols, "Characters, as themselves")
      ->type_name("STRING");
}

void add_quality(CLI::App& app, GenerateRequest& request) {
  AdfOptions& adf = request.adf;
  app.add_option("--min-px", adf.min_px, "Smallest size [px/em]")
      ->capture_default_str();
  app.add_option("--max-px", adf.max_px, "Largest size [px/em]")
      ->capture_default_str();
  app.add_option_function<std::string>(
         "--tolerance",
         [&adf](const std::string& text) {
           adf.tolerance = parse_tolerance(text);
         },
         "Largest error of a pixel at any of these sizes")
      ->type_name("N/255")
      ->default_str("16/255");
  app.add_option_function<std::string>(
         "--predicate",
         [&adf](const std::string& value) {
           if (value != "size" && value != "fixed") {
             throw CLI::ValidationError("--predicate",
                                        "'" + value +
                                            "' is not known; use 'size' or "
                                            "'fixed'");
           }
           adf.predicate =
               value == "fixed" ? Predicate::fixed : Predicate::size_aware;
         },
         "What is good enough: 'size', the tolerance over the range of "
         "sizes; 'fixed', 1/1024 em near the edge")
      ->type_name("size|fixed")
      ->default_str("size");
  app.add_option("--effort", adf.effort,
                 "How hard to fit cells before they are divided; 0: no fit, "
                 "about half as many cells again; above 5: hardly fewer")
      ->check(CLI::Range(0, 9))
      ->type_name("0..9")
      ->capture_default_str();
}

}  // namespace

void add_generator_options(CLI::App& app, GenerateRequest& request) {
  add_selection(app, request);
  add_quality(app, request);
  add_fixed_choice(app, "--cells", "samples", "fields", "Kind of cells");
  add_fixed_choice(app, "--coding", "direct", "packed", "How cells lie in ROM");
}

}  // namespace inkcell::gen
