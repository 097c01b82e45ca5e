// Folders of tests, and the project that they begin with.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace inkcell::design::test {

/// A new folder below the system's temporary one, removed in the end.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The bytes of every file in a folder, by its path within.
std::map<std::string, std::string> contents_of(
    const std::filesystem::path& folder);

void write_text(const std::filesystem::path& file, const std::string& text);

/// Makes a UFO as other programs write it: tabs, keys of their own, a second
/// layer, data and images that nobody here knows, glyphs of lines, cubics,
/// quadratics with implied points, open contours and components.
void make_foreign_ufo(const std::filesystem::path& folder);

}  // namespace inkcell::design::test
