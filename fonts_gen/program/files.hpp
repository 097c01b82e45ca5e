// The files that a program reads and writes: which of them are the same.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

namespace inkcell::tools {

/// The folder that a file lies in, "." where its path names none.
inline std::filesystem::path folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  return folder.empty() ? std::filesystem::path(".") : folder;
}

/// What a path is in the end if it is a symbolic link, which need not lead to
/// anything that exists. Throws std::runtime_error if it has no end.
inline std::filesystem::path follow_links(std::filesystem::path file) {
  constexpr int kMostLinks = 40;  // that may follow each other, as on Linux
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

/// Whether two paths lead to one file, be it there or not.
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

/// Throws std::runtime_error if one of `targets` is the same file as another or
/// as one of `inputs`, by whatever path. Empty paths are skipped.
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
