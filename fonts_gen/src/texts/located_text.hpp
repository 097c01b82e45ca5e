// Characters of a file, and where they are.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace inkcell::gen {

/// A character and its line, from 1.
struct LocatedCharacter {
  char32_t value = 0;
  int line = 0;
};

using LocatedText = std::vector<LocatedCharacter>;

/// What a file shows in one language.
struct LanguageText {
  std::string language;  // a tag of BCP 47; empty: that of no translation
  LocatedText text;
};

/// Adds the characters of UTF-8 `text` that are shown, all as of one line.
/// Throws Error, which names `file`, if it is not UTF-8.
void add_shown(std::string_view text,
               int line,
               const std::string& file,
               LocatedText& out);

/// The bytes of a string in quotation marks, whose escapes of C are read.
/// Throws Error, which names `file` and `line`.
std::string unquoted(std::string_view text, const std::string& file, int line);

/// A text without the mark that may begin a file of UTF-8.
std::string_view without_byte_order_mark(std::string_view text);

/// The number of the line of a byte, from 1.
int line_at(std::string_view content, size_t offset);

/// Throws Error: "file:line: what".
[[noreturn]] void refuse(const std::string& file,
                         int line,
                         const std::string& what);

}  // namespace inkcell::gen
