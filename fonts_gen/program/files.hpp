// The files of a program, and whether two of them are the same.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace inkcell::tools {

/// The folder of a file, "." if its path names none.
inline std::filesystem::path folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  return folder.empty() ? std::filesystem::path(".") : folder;
}

/// The target of a symbolic link, which may not exist; other paths unchanged.
/// Throws std::runtime_error for a cycle.
inline std::filesystem::path follow_links(std::filesystem::path file) {
  constexpr int kMostLinks = 40;  // in a row, as on Linux
  const std::string name = file.string();
  std::error_code error;
  for (int i = 0; i < kMostLinks; ++i) {
    if (!std::filesystem::is_symlink(
            std::filesystem::symlink_status(file, error))) {
      return file;
    }
    // An absolute link replaces the whole path.
    file = folder_of(file) / std::filesystem::read_symlink(file, error);
    if (error) {
      break;
    }
  }
  throw std::runtime_error(
      name + ": is a symbolic link that leads nowhere; remove it");
}

/// Whether two paths lead to one file, which may not exist.
inline bool is_same_file(const std::filesystem::path& a,
                         const std::filesystem::path& b) {
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) {
    return true;
  }
  const auto place = [&error](const std::filesystem::path& file) {
    const std::filesystem::path whole = follow_links(file);
    return std::filesystem::weakly_canonical(folder_of(whole), error) /
           whole.filename();
  };
  return place(a) == place(b);
}

/// Ends the version in the names of a TTF from inkcell-design.
inline constexpr std::string_view kExportMark = "; inkcell-design";

/// Whether a font file is an export of inkcell-design, by its mark in UTF-16.
inline bool is_export(const std::filesystem::path& font) {
  std::string mark;
  for (const char c : kExportMark) {
    mark += '\0';
    mark += c;
  }
  std::ifstream in(font, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)),
                          std::istreambuf_iterator<char>());
  return bytes.find(mark) != std::string::npos;
}

/// Throws std::runtime_error if `target` is in a folder of system fonts, or
/// would replace a font file that is not an export. Deriving a name from the
/// source's, X.bin of X.ttf, leads there by mistake.
inline void refuse_among_fonts(const std::filesystem::path& target) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path whole = follow_links(target);
  const fs::path folder = fs::weakly_canonical(folder_of(whole), error);
  for (const char* of_fonts :
       {"/usr/share/fonts", "/usr/local/share/fonts", "/Library/Fonts",
        "/System/Library/Fonts", "C:\\Windows\\Fonts"}) {
    const fs::path root(of_fonts);
    const auto [left, at] =
        std::mismatch(root.begin(), root.end(), folder.begin(), folder.end());
    if (left == root.end()) {
      throw std::runtime_error(target.string() +
                               ": would lie among the fonts of the system; "
                               "name a file in a folder of yours");
    }
  }
  char magic[4] = {};
  std::ifstream in(whole, std::ios::binary);
  in.read(magic, sizeof magic);
  const std::string_view found(magic, static_cast<size_t>(in.gcount()));
  for (const std::string_view font :
       {std::string_view("\0\1\0\0", 4), std::string_view("OTTO"),
        std::string_view("true"), std::string_view("ttcf"),
        std::string_view("wOFF"), std::string_view("wOF2")}) {
    if (found == font && !is_export(whole)) {
      throw std::runtime_error(target.string() +
                               ": is a font file, which would be replaced; "
                               "name another file");
    }
  }
}

/// Throws std::runtime_error if one of `targets` is the same file as another or
/// as one of `inputs`, by any path. Empty paths are skipped.
inline void check_apart(const std::vector<std::filesystem::path>& targets,
                        const std::vector<std::filesystem::path>& inputs) {
  for (size_t i = 0; i < targets.size(); ++i) {
    const auto refuse_if_same = [&](const std::filesystem::path& other,
                                    const char* what) {
      if (!targets[i].empty() && !other.empty() &&
          is_same_file(targets[i], other)) {
        throw std::runtime_error(targets[i].string() + ": " + what);
      }
    };
    for (const std::filesystem::path& input : inputs) {
      refuse_if_same(input, "is read, too; name another file to write");
    }
    for (size_t k = 0; k < i; ++k) {
      refuse_if_same(targets[k], "would be written twice; name two files");
    }
  }
}

}  // namespace inkcell::tools
