#include "pipeline/missing.hpp"

#include <algorithm>
#include <cstddef>

#include "base/error.hpp"
#include "source/named_sets.hpp"
#include "texts/shown_texts.hpp"

namespace inkcell::gen {
namespace {

// Characters that the error names.
constexpr size_t kListedCharacters = 10;

std::string place_of_line(const std::string& file, int line) {
  return file + ":" + std::to_string(line) + ": ";
}

// Where a text file has a character first; empty if it does not.
std::string place_in_text(const std::filesystem::path& file, char32_t c) {
  const std::string text = read_text_file(file, "--text-file");
  const size_t found = text.find(to_utf8(c));
  if (found == std::string::npos) {
    return "";
  }
  return place_of_line(file.string(), line_at(text, found));
}

// The same of a source or a translation.
std::string place_in_source(const std::filesystem::path& file, char32_t c) {
  for (const LanguageText& shown : shown_texts(file, "--strings-from")) {
    for (const LocatedCharacter& found : shown.text) {
      if (found.value == c) {
        return place_of_line(file.string(), found.line);
      }
    }
  }
  return "";
}

// What asks for a character: "ui.txt:3: ".
std::string place_of(const GenerateRequest& request,
                     const std::vector<NamedString>& strings,
                     const std::vector<std::filesystem::path>& sources,
                     char32_t c) {
  for (const NamedString& string : strings) {
    if (string.line.text.find(c) != std::u32string::npos) {
      return place_of_line(string.file, string.line_number);
    }
  }
  std::string place;
  for (size_t i = 0; i < sources.size() && place.empty(); ++i) {
    place = place_in_source(sources[i], c);
  }
  for (size_t i = 0; i < request.text_files.size() && place.empty(); ++i) {
    place = place_in_text(request.text_files[i], c);
  }
  if (place.empty()) {
    const auto has = [c](const std::string& text) {
      return text.find(to_utf8(c)) != std::string::npos;
    };
    const bool is_morph =
        std::any_of(request.morphs.begin(), request.morphs.end(), has);
    CharSet named;
    for (const std::string& list : request.sets) {
      add_named_sets(list, named);
    }
    place = has(request.symbols)    ? "--symbols: "
            : named.count(c) != 0   ? "--set: "
            : is_morph              ? "--morph: "
            : request.merge.empty() ? "--chars: "
                                    : "--chars or --merge: ";
  }
  return place;
}

}  // namespace

void refuse_missing(const GenerateRequest& request,
                    const std::string& font,
                    const std::vector<char32_t>& missing) {
  const std::vector<NamedString> strings = strings_of(request);
  const std::vector<std::filesystem::path> sources = sources_of(request);
  std::string text =
      font + ": " + std::to_string(missing.size()) +
      (missing.size() == 1 ? " character is" : " characters are") +
      " not in the font:\n";
  for (size_t i = 0; i < std::min(missing.size(), kListedCharacters); ++i) {
    text += "  " + place_of(request, strings, sources, missing[i]) +
            describe(missing[i]) + "\n";
  }
  if (missing.size() > kListedCharacters) {
    text += "  ...\n";
  }
  throw Error(text +
              "use a font that has them, take them out of the text, or leave "
              "out --strict: the box of .notdef stands there then");
}

}  // namespace inkcell::gen
