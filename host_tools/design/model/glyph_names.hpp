// Names of glyphs by their characters.
#pragma once

#include <optional>
#include <string>

namespace inkcell::design {

/// The name in the Adobe Glyph List for New Fonts; "uni" or "u" and the code
/// point for other characters.
std::string name_of_character(char32_t c);

/// The character that name_of_character() names so; none for other names.
std::optional<char32_t> character_of_name(const std::string& name);

}  // namespace inkcell::design
