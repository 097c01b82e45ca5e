// Temporary folders, and a project to start from.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace inkcell::design::test {

/// A new folder in the system's temporary one, removed at the end.
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

/// The bytes of all files in a folder, by relative path.
std::map<std::string, std::string> contents_of(
    const std::filesystem::path& folder);

void write_text(const std::filesystem::path& file, const std::string& text);

/// Makes a UFO as other programs write it: tabs, foreign keys, a second layer,
/// foreign data and images, glyphs of lines, cubics, quadratics with implied
/// points, open contours and components.
void make_foreign_ufo(const std::filesystem::path& folder);

}  // namespace inkcell::design::test
