// Sets of characters, from ranges, text files and strings.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace inkcell::gen {

/// Unicode code points in ascending order.
using CharSet = std::set<char32_t>;

/// The default: printable ASCII.
inline constexpr std::string_view kDefaultChars = "0x20-0x7E";

/// Adds a list such as "0x20-0x7E,U+B0,176,A-Z". Items are separated by commas;
/// an end of a range is hexadecimal (0x or U+), decimal, or one character.
/// Surrogates in a range are skipped. Throws Error.
void add_ranges(std::string_view list, CharSet& out);

/// Adds every character of UTF-8 text except control characters (line ends,
/// tabs) and the byte order mark. `source` names the text in errors.
void add_text(std::string_view text, const std::string& source, CharSet& out);

/// add_text of a whole file. Throws Error.
void add_text_file(const std::filesystem::path& file, CharSet& out);

/// The bytes of a file. Throws Error that names `option`.
std::string read_text_file(const std::filesystem::path& file,
                           const std::string& option);

/// Reads one character from the front of `text`, which must not be empty;
/// nothing if it is not UTF-8.
std::optional<char32_t> read_utf8(std::string_view& text);

/// Whether a character belongs in a font: no control character, no byte order
/// mark.
bool is_shown(char32_t code_point);

/// Whether a missing character leaves a gap or a box: the space, and all
/// visible ones.
bool is_missed(char32_t code_point);

/// Whether a code point is for private use, like those of icons.
constexpr bool is_private(char32_t c) {
  return (c >= 0xe000 && c <= 0xf8ff) || c >= 0xf0000;
}

/// UTF-8 of one code point.
std::string to_utf8(char32_t code_point);

/// The form of a character in messages: U+0041 'A'.
std::string describe(char32_t code_point);

}  // namespace inkcell::gen
