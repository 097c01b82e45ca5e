// The characters of string literals in C and C++ sources.
#pragma once

#include <string>
#include <string_view>

#include "texts/located_text.hpp"

namespace inkcell::gen {

/// The characters of all string literals of a source, in order: with any
/// prefix, also raw; adjacent literals are joined. Comments, character
/// constants, and directives with a file name or a message (#include, #error,
/// #pragma and the like) are skipped. Nothing else is evaluated: both branches
/// of an #if count.
///
/// Control characters are left out, and literals whose escape sequences do not
/// give UTF-8, as these are data. `file` names the source in errors.
///
/// Throws Error for a literal that is not UTF-8 in the file itself.
LocatedText literal_characters(std::string_view source,
                               const std::string& file);

}  // namespace inkcell::gen
