// Names of glyphs as names of files.
#pragma once

#include <set>
#include <string>

namespace inkcell::design {

/// The file for a glyph by the rules of UFO 3: capitals are followed by "_",
/// characters that some file system refuses become "_", names that Windows
/// reserves are changed, and a number is added if a file that differs in case
/// only is in `taken`, which holds lower-case names and gets the new one.
std::string glif_file_name(const std::string& glyph,
                           std::set<std::string>& taken);

}  // namespace inkcell::design
