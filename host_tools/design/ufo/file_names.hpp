// Names of glyphs as names of files.
#pragma once

#include <set>
#include <string>

namespace inkcell::design {

/// The file name of a glyph by the rules of UFO 3: capitals are followed by
/// "_", characters that a file system refuses become "_", names that Windows
/// reserves are changed, and a number is added if a name in `taken` differs in
/// case only. `taken` has lower-case names; the new one is added.
std::string glif_file_name(const std::string& glyph,
                           std::set<std::string>& taken);

}  // namespace inkcell::design
