#include "texts/language_name.hpp"

#include <algorithm>
#include <cstddef>

namespace inkcell::gen {
namespace {

bool is_lower(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}

template <typename Is>
bool all(std::string_view text, Is is) {
  return std::all_of(text.begin(), text.end(), is);
}

bool is_script(std::string_view part) {
  return part.size() == 4 && is_upper(part[0]) && all(part.substr(1), is_lower);
}

bool is_region(std::string_view part) {
  return (part.size() == 2 && all(part, is_upper)) ||
         (part.size() == 3 &&
          all(part, [](char c) { return c >= '0' && c <= '9'; }));
}

// Takes a part up to a separator off the front.
std::string_view take_part(std::string_view& name) {
  const size_t end = std::min(name.find_first_of("-_"), name.size());
  const std::string_view part = name.substr(0, end);
  name.remove_prefix(std::min(end + 1, name.size()));
  return part;
}

// The language of the end of a name: of app_pt_BR that is pt-BR.
std::string language_at_end(std::string_view name) {
  while (!name.empty()) {
    const std::string tag = language_tag(name);
    if (!tag.empty()) {
      return tag;
    }
    const size_t end = name.find_first_of("-_.");
    name.remove_prefix(end == std::string_view::npos ? name.size() : end + 1);
  }
  return "";
}

}  // namespace

std::string language_tag(std::string_view name) {
  const std::string_view language = take_part(name);
  if (language.size() < 2 || language.size() > 3 || !all(language, is_lower)) {
    return "";
  }
  std::string tag(language);
  std::string_view part = take_part(name);
  if (is_script(part)) {
    tag += "-" + std::string(part);
    part = take_part(name);
  }
  if (is_region(part)) {
    tag += "-" + std::string(part);
    part = take_part(name);
  }
  return part.empty() && name.empty() ? tag : "";
}

std::string language_of_path(const std::filesystem::path& file) {
  std::string tag = language_at_end(file.stem().string());
  for (std::filesystem::path folder = file.parent_path();
       tag.empty() && folder.has_filename(); folder = folder.parent_path()) {
    const std::string name = folder.filename().string();
    tag = language_tag(name);
    if (name != "LC_MESSAGES") {
      break;  // folders above are not of translations
    }
  }
  return tag;
}

}  // namespace inkcell::gen
