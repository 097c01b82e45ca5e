#include "app/face_options.hpp"

#include <string>

#include "base/error.hpp"

namespace inkcell::gen {
namespace {

// An option whose text `parse` reads into `place`.
void add_place(CLI::App& app,
               const std::string& option,
               IconPlace& place,
               void (*parse)(const std::string&, IconPlace&),
               const std::string& values,
               const std::string& usual,
               const std::string& help) {
  app.add_option_function<std::string>(
         option,
         [option, &place, parse](const std::string& text) {
           try {
             parse(text, place);
           } catch (const Error& error) {
             throw CLI::ValidationError(option, error.what());
           }
         },
         help)
      ->type_name(values)
      ->default_str(usual);
}

}  // namespace

void add_face_options(CLI::App& app, GenerateRequest& request) {
  app.add_option("--merge", request.merge,
                 "Another face: it gives the characters of LIST, or all that "
                 "are still missing; the first face that has one gives it; "
                 "repeatable. SETTING is instance=NAME, TAG=VALUE of an axis, "
                 "face=N, height=em|cap|NUMBER or "
                 "baseline=own|middle|bottom|NUMBER. Text stands on its own "
                 "baseline; icons in the middle of capitals: a face is one of "
                 "icons if no letter, mark or digit is taken from it, and "
                 "either a private use character is or it lacks Latin letters")
      ->type_name("FILE[:SETTING,...][=LIST]");
  app.add_option("--svg", request.svg_files,
                 "An icon as a glyph, such as wifi.svg=0xE001; repeatable")
      ->type_name("FILE=CODE");
  app.add_option("--svg-dir", request.svg_folders,
                 "All icons of a folder: code points by its file 'codepoints', "
                 "by names such as 0xE001-wifi.svg, or from U+E000 on; "
                 "repeatable")
      ->type_name("DIR");
  add_place(app, "--svg-height", request.icon_place, parse_icon_height,
            "em|cap|NUMBER", "em",
            "Height of an icon's viewBox: an em, that of capitals, or a number "
            "of em");
  add_place(app, "--svg-baseline", request.icon_place, parse_icon_baseline,
            "middle|bottom|NUMBER", "middle",
            "The viewBox is centred on capitals, stands on the baseline, or "
            "begins a number of em above it");
}

}  // namespace inkcell::gen
