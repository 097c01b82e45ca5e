#include "pipeline/unshaped.hpp"

#include <set>

#include "source/shape_script.hpp"
#include "source/shaping_need.hpp"
#include "texts/shown_texts.hpp"

namespace inkcell::gen {
namespace {

// Warns once of each script, whichever text it is in, but for those of --shape.
class ScriptWarnings {
 public:
  ScriptWarnings(const std::string& shapes, Warnings& out) : out_(out) {
    if (!shapes.empty()) {
      for (const ShapeScript& shaped : parse_shape_scripts(shapes)) {
        told_.insert(script_of(shaped));
      }
    }
  }

  // `file` is empty for a text of the command line.
  void add(const LocatedText& text, const std::string& file) {
    std::u32string characters;
    for (const LocatedCharacter& found : text) {
      characters += found.value;
    }
    for (const UnshapedScript& script : unshaped_scripts(characters)) {
      if (told_.insert(script.script).second) {
        const std::string place =
            file.empty()
                ? ""
                : file + ":" + std::to_string(text[script.at].line) + ": ";
        out_.push_back({Warning::Kind::unshaped,
                        place + unshaped_message(script, characters)});
      }
    }
  }

 private:
  Warnings& out_;
  std::set<hb_script_t> told_;
};

LocatedText lines_of(const std::filesystem::path& file) {
  const std::string content = read_text_file(file, "--text-file");
  LocatedText text;
  int line = 1;
  for (std::string_view rest = content; !rest.empty(); ++line) {
    const size_t end = rest.find('\n');
    add_shown(rest.substr(0, end), line, file.string(), text);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return text;
}

}  // namespace

void tell_of_unshaped(const GenerateRequest& request, Warnings& warnings) {
  ScriptWarnings scripts(request.shapes, warnings);
  LocatedText symbols;
  add_shown(request.symbols, 0, "--symbols", symbols);
  scripts.add(symbols, "");
  for (const std::filesystem::path& file : request.text_files) {
    scripts.add(lines_of(file), file.string());
  }
  for (const std::filesystem::path& file : sources_of(request)) {
    for (const LanguageText& shown : shown_texts(file, "--strings-from")) {
      scripts.add(shown.text, file.string());
    }
  }
}

}  // namespace inkcell::gen
