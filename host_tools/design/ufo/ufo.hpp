// Projects as UFO 3 folders.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "model/project.hpp"

namespace inkcell::design {

/// The content of a folder when it was read: unchanged data is written back
/// byte for byte, and unknown files survive.
struct UfoFiles {
  std::filesystem::path folder;
  /// The bytes of every file of the format, by its path within the folder.
  std::map<std::string, std::string> texts;
  /// All other files: data, pictures that no glyph uses, files of other
  /// programs.
  std::vector<std::string> foreign;
  /// As read.
  Project project;
  /// File of each glyph, by layer folder and name.
  std::map<std::string, std::map<std::string, std::string>> glyph_files;
};

/// Reads a project. Throws Error that names the file that is wrong.
UfoFiles read_ufo(const std::filesystem::path& folder);

/// Writes `project` to `folder`, completely or not at all: it is written beside
/// its place, flushed to the disk, and swapped in. `files` are those that the
/// project was read from, empty for a new one; afterwards they are those of
/// `folder`. Throws Error.
void write_ufo(const Project& project,
               const std::filesystem::path& folder,
               UfoFiles& files);

/// The files that write_ufo() would write, without foreign ones.
std::map<std::string, std::string> ufo_texts(const Project& project,
                                             const UfoFiles& files);

/// A hash of all files of the format; 16 hexadecimal digits.
std::string digest_of(const std::map<std::string, std::string>& texts);

}  // namespace inkcell::design
