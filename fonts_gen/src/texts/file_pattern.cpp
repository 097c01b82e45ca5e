#include "texts/file_pattern.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string_view>

#include "base/error.hpp"

namespace inkcell::gen {
namespace {

namespace fs = std::filesystem;

bool has_wildcard(const std::string& part) {
  return part.find_first_of("*?[") != std::string::npos;
}

// Whether the set that begins a pattern, such as [a-f_] or [!0-9], has `c`.
// Takes the set off the pattern; one without an end is a bracket alone.
bool take_set(std::string_view& pattern, char c) {
  const size_t first =
      pattern.size() > 1 && (pattern[1] == '!' || pattern[1] == '^') ? 2 : 1;
  const size_t end = pattern.find(']', first + 1);
  if (end == std::string_view::npos) {
    pattern.remove_prefix(1);
    return c == '[';
  }
  bool has = false;
  for (size_t i = first; i < end; ++i) {
    const bool is_range = i + 2 < end && pattern[i + 1] == '-';
    has = has || (c >= pattern[i] && c <= pattern[is_range ? i + 2 : i]);
    i += is_range ? 2 : 0;
  }
  pattern.remove_prefix(end + 1);
  return has == (first == 1);
}

// Whether a pattern of the shell stands for a name.
bool matches(std::string_view pattern, std::string_view name) {
  while (!pattern.empty()) {
    const char next = pattern[0];
    if (next == '*') {
      pattern.remove_prefix(1);
      for (size_t skipped = 0; skipped <= name.size(); ++skipped) {
        if (matches(pattern, name.substr(skipped))) {
          return true;
        }
      }
      return false;
    }
    if (name.empty()) {
      return false;
    }
    if (next == '[') {
      if (!take_set(pattern, name[0])) {
        return false;
      }
    } else {
      if (next != '?' && next != name[0]) {
        return false;
      }
      pattern.remove_prefix(1);
    }
    name.remove_prefix(1);
  }
  return name.empty();
}

class Search {
 public:
  explicit Search(const fs::path& pattern) {
    for (const fs::path& part : pattern.relative_path()) {
      parts_.push_back(part.string());
    }
    visit(pattern.root_path(), 0);
  }

  std::vector<fs::path> found() const { return {found_.begin(), found_.end()}; }

 private:
  // Finds matches of the parts from `part` on in `folder`, which is empty for
  // the working directory.
  void visit(const fs::path& folder, size_t part) {
    if (part == parts_.size()) {
      std::error_code error;
      if (fs::is_regular_file(folder, error)) {
        found_.insert(folder.lexically_normal());
      }
      return;
    }
    const std::string& name = parts_[part];
    if (name == "**") {
      visit(folder, part + 1);
      for (const fs::path& entry : entries(folder)) {
        // A link to a folder may lead back to here.
        const bool is_folder =
            fs::is_directory(fs::symlink_status(folder / entry));
        if (is_folder && entry.string()[0] != '.') {
          visit(folder / entry, part);
        }
      }
    } else if (has_wildcard(name)) {
      for (const fs::path& entry : entries(folder)) {
        const std::string text = entry.string();
        if ((text[0] != '.' || name[0] == '.') && matches(name, text)) {
          visit(folder / entry, part + 1);
        }
      }
    } else {
      visit(folder / name, part + 1);
    }
  }

  // The names in a folder; none if it is not one.
  std::vector<fs::path> entries(const fs::path& folder) const {
    const fs::path place = folder.empty() ? fs::path(".") : folder;
    std::error_code error;
    std::vector<fs::path> names;
    if (!fs::is_directory(place, error)) {
      return names;
    }
    fs::directory_iterator entry(place, error);
    if (error) {
      throw Error(place.string() + ": cannot be read: " + error.message());
    }
    for (; entry != fs::directory_iterator(); entry.increment(error)) {
      names.push_back(entry->path().filename());
    }
    return names;
  }

  std::vector<std::string> parts_;
  std::set<fs::path> found_;
};

}  // namespace

std::vector<fs::path> matching_files(const std::string& pattern,
                                     const std::string& option) {
  const std::vector<fs::path> found = Search(pattern).found();
  if (found.empty()) {
    throw Error(option + ": no file matches '" + pattern +
                "'; check the path from this folder, and write ** for any "
                "folders, in quotes, as in 'src/**/*.c'");
  }
  return found;
}

}  // namespace inkcell::gen
