// Escape sequences of C and C++.
#pragma once

#include <optional>
#include <string_view>

namespace inkcell::gen {

/// What an escape sequence stands for.
struct Escape {
  char32_t value = 0;
  /// It is a code unit, which octal and hexadecimal numbers are: one byte of
  /// UTF-8 in most strings. Others are characters.
  bool is_unit = false;
};

/// Takes the sequence behind a backslash off the front of `text`. Nothing, and
/// `text` untouched, if there is none that C or C++ has.
std::optional<Escape> take_escape(std::string_view& text);

}  // namespace inkcell::gen
