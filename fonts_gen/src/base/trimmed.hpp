// Trims a text.
#pragma once

#include <cstddef>
#include <string_view>

namespace inkcell::gen {

/// `text` without the characters of `blanks` at both ends. A view of `text`,
/// which must outlive it.
inline std::string_view trimmed(std::string_view text,
                                std::string_view blanks = " \t\r") {
  const size_t begin = text.find_first_not_of(blanks);
  return begin == std::string_view::npos
             ? text.substr(0, 0)
             : text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

}  // namespace inkcell::gen
