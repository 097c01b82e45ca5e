// Finds files by a pattern.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace inkcell::gen {

/// The files that match `pattern`, ordered by name. `*`, `?` and `[...]` work
/// as in the shell; `**` stands for any number of folders, also none. Names
/// that begin with a dot only match patterns that begin with a dot. A pattern
/// without such characters is a file name.
///
/// Throws Error, which names `option`, if no file matches or a folder cannot be
/// read.
std::vector<std::filesystem::path> matching_files(const std::string& pattern,
                                                  const std::string& option);

}  // namespace inkcell::gen
