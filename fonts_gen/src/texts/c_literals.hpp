// The characters of string literals in C and C++ sources.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace inkcell::gen {

/// A character, and the line that it stands in, from 1.
struct LocatedCharacter {
  char32_t value = 0;
  int line = 0;
};

/// The characters of all string literals of a source, in their order: of any
/// prefix, raw ones as well; literals that follow each other are one. Comments,
/// character constants, and directives that take a file's name or a message
/// (#include, #error, #pragma and the like) have none; nothing else is
/// evaluated, so that both branches of an #if count.
///
/// Control characters are left out, as are literals that are not UTF-8 by their
/// escape sequences: these are data. `file` names the source in errors.
///
/// Throws Error for a literal that is not UTF-8 as it stands in the file.
std::vector<LocatedCharacter> literal_characters(std::string_view source,
                                                 const std::string& file);

}  // namespace inkcell::gen
