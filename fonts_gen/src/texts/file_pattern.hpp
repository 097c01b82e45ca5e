// Files by a pattern of their names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace inkcell::gen {

/// The files that match `pattern`, in the order of their names. In a part of
/// the path, `*`, `?` and `[...]` stand for what the shell takes them for; the
/// part `**` stands for any number of folders, none too. Names that begin with
/// a point match only patterns that do. A pattern without such characters is
/// the name of a file.
///
/// Throws Error if no file matches, or a folder cannot be read. `option` names
/// the pattern in it.
std::vector<std::filesystem::path> matching_files(const std::string& pattern,
                                                  const std::string& option);

}  // namespace inkcell::gen
