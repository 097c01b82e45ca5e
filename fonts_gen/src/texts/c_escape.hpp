// Escape sequences of C and C++.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace inkcell::gen {

/// The value of an escape sequence.
struct Escape {
  char32_t value = 0;
  /// True for octal and hexadecimal numbers, which are code units: one byte of
  /// UTF-8 in most strings. Other escapes are characters.
  bool is_unit = false;
};

/// Reads the escape sequence after a backslash from the front of `text`.
/// Nothing, and `text` untouched, if C and C++ do not have it.
std::optional<Escape> read_escape(std::string_view& text);

/// What an escape sequence adds to a string of UTF-8.
std::string bytes_of(const Escape& escape);

}  // namespace inkcell::gen
