// Files of named strings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "source/line_text.hpp"

namespace inkcell::gen {

/// A named string of a program's user interface.
struct NamedString {
  std::string name;  // an identifier of C and C++
  LineText line;
  std::string file;
  int line_number = 0;  // from 1
};

/// Adds the strings of a UTF-8 file, one a line:
///
///   # A comment.
///   title = Settings
///   greeting [ar] = السلام عليكم
///   price [he, rtl] = "  ₪ 5"
///
/// Brackets hold a language (BCP 47) and a direction, ltr or rtl, or one of
/// both. Blanks around the text are no part of it. A text that begins with a
/// quotation mark ends with one, and may have escapes of C.
///
/// Throws Error for a file that cannot be read or is not UTF-8, for any other
/// line, control characters, names that are no identifiers and names that `out`
/// has already.
void add_string_file(const std::filesystem::path& file,
                     std::vector<NamedString>& out);

}  // namespace inkcell::gen
