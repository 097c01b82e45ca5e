// Writes a font in each file format.
#pragma once

#include <string>

#include "pipeline/generate.hpp"

namespace inkcell::gen {

enum class OutputFormat { bin, hpp, c };

/// The content of a font file in the given form. `name` is the identifier of
/// the array in hpp and c; the array of hpp is fonts::<name>, and the coding
/// of a font with strikes fonts::<name>_coding. The array is in
/// `section` if that is not empty. A string is fonts::<name>_strings::<string>
/// in hpp, <name>_strings_<string> in c; an icon's UTF-8 is
/// fonts::<name>_icons::k<Icon> and <name>_icons_<Icon>. bin has neither.
std::string encode(const RomFont& font,
                   OutputFormat format,
                   const std::string& name,
                   const std::string& section = {});

/// The header for a font of --paged, of C++: what StoredFont needs to know of
/// its file, in fonts::<name>, and icons as encode().
std::string encode_stored_header(const RomFont& font, const std::string& name);

/// The header for the form c: declares the array, its size and the strings.
std::string encode_c_header(const RomFont& font, const std::string& name);

}  // namespace inkcell::gen
