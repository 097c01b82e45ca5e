// Temporary folders, and fonts and projects to start from.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "import/font_import.hpp"
#include "model/error.hpp"
#include "source/font_source.hpp"

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

/// The glyphs of these characters, without .notdef.
gen::SourceFont letters_of(const std::filesystem::path& font,
                           const std::string& characters);

/// Imports ranges of characters of a face below /usr/share/fonts/truetype.
Project face(const std::string& file,
             const std::string& ranges,
             Composites composites = Composites::keep);

void run(Project& project, const Value& command);

/// Adds a glyph, whose contours are a list in JSON.
void add_glyph(Project& project,
               const std::string& name,
               std::vector<char32_t> unicodes,
               const std::string& contours,
               const std::vector<ComponentUse>& components = {});

/// The text of the Error that `work` throws; "" if it throws none.
template <typename Work>
std::string refusal_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace inkcell::design::test
