#include "source/char_set.hpp"

#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "inkcell/text.hpp"

namespace inkcell::gen {
namespace {

constexpr char32_t kLastCodePoint = 0x10ffff;

constexpr bool is_surrogate(char32_t c) {
  return c >= 0xd800 && c <= 0xdfff;
}

constexpr bool is_control(char32_t c) {
  return c < 0x20 || (c >= 0x7f && c < 0xa0);
}

std::optional<char32_t> parse_number(std::string_view digits, int base) {
  char32_t value = 0;
  for (const char c : digits) {
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : 99;
    if (digit >= base) {
      return std::nullopt;
    }
    value = value * static_cast<char32_t>(base) + static_cast<char32_t>(digit);
    if (value > kLastCodePoint) {
      return std::nullopt;
    }
  }
  return digits.empty() ? std::nullopt : std::optional<char32_t>(value);
}

bool is_digit(std::string_view text) {
  return text.size() == 1 && text[0] >= '0' && text[0] <= '9';
}

// An end of a range. A single digit is a character, as a letter is: code points
// below 10 are control characters, which no font needs.
std::optional<char32_t> parse_end(std::string_view text) {
  const std::string_view prefix = text.substr(0, 2);
  if (prefix == "0x" || prefix == "0X" || prefix == "U+" || prefix == "u+") {
    return parse_number(text.substr(2), 16);
  }
  if (is_digit(text)) {
    return static_cast<char32_t>(text[0]);
  }
  if (const auto number = parse_number(text, 10)) {
    return number;
  }
  if (text.empty()) {
    return std::nullopt;
  }
  const auto literal = read_utf8(text);
  return text.empty() ? literal : std::nullopt;
}

[[noreturn]] void refuse_item(std::string_view item, const char* why) {
  throw Error("--chars: '" + std::string(item) + "' " + why);
}

void add_item(std::string_view item, CharSet& out) {
  const size_t dash = item.find('-', 1);
  const std::string_view begin = item.substr(0, dash);
  const std::string_view end =
      dash == std::string_view::npos ? begin : item.substr(dash + 1);
  const auto first = parse_end(begin);
  const auto last = parse_end(end);
  if (!first || !last) {
    refuse_item(item,
                "is not a code point or a range; write 0x41, U+41, 65 or "
                "0x41-0x5A, or name characters with --symbols");
  }
  if (is_digit(begin) != is_digit(end) &&
      (parse_number(begin, 10) && parse_number(end, 10))) {
    refuse_item(item,
                "mixes a digit with a code point; write 0-9 for digits, or "
                "code points as 0x30-0x41");
  }
  if (*first > *last) {
    refuse_item(item, "runs backwards; write the smaller code point first");
  }
  if (*first < 0x20) {
    refuse_item(item,
                "begins with a control character; printable ones begin at "
                "0x20");
  }
  if (is_surrogate(*first) && is_surrogate(*last)) {
    refuse_item(item, "holds nothing but surrogates");
  }
  for (char32_t c = *first; c <= *last; ++c) {
    if (!is_surrogate(c)) {
      out.insert(out.end(), c);
    }
  }
}

}  // namespace

void add_ranges(std::string_view list, CharSet& out) {
  while (true) {
    const size_t comma = list.find(',');
    std::string_view item = list.substr(0, comma);
    while (!item.empty() && item.front() == ' ') {
      item.remove_prefix(1);
    }
    while (!item.empty() && item.back() == ' ') {
      item.remove_suffix(1);
    }
    if (item.empty()) {
      refuse_item(list, "has an empty item; separate code points by one comma");
    }
    add_item(item, out);
    if (comma == std::string_view::npos) {
      return;
    }
    list.remove_prefix(comma + 1);
  }
}

std::optional<char32_t> read_utf8(std::string_view& text) {
  const auto lead = static_cast<uint8_t>(text[0]);
  const size_t length = lead < 0x80             ? 1
                        : (lead & 0xe0) == 0xc0 ? 2
                        : (lead & 0xf0) == 0xe0 ? 3
                        : (lead & 0xf8) == 0xf0 ? 4
                                                : 0;
  if (length == 0 || length > text.size()) {
    return std::nullopt;
  }
  char32_t c = length == 1 ? lead : lead & (0x7fu >> length);
  for (size_t i = 1; i < length; ++i) {
    const auto next = static_cast<uint8_t>(text[i]);
    if ((next & 0xc0) != 0x80) {
      return std::nullopt;
    }
    c = c << 6 | (next & 0x3fu);
  }
  // The least code point that needs this many bytes.
  constexpr char32_t kLeast[5] = {0, 0, 0x80, 0x800, 0x10000};
  if (c < kLeast[length] || c > kLastCodePoint || is_surrogate(c)) {
    return std::nullopt;
  }
  text.remove_prefix(length);
  return c;
}

bool is_shown(char32_t c) {
  return !is_control(c) && c != 0xfeff;
}

bool is_missed(char32_t c) {
  return c == U' ' || needs_glyph(c);
}

void add_text(std::string_view text, const std::string& source, CharSet& out) {
  const size_t size = text.size();
  while (!text.empty()) {
    const size_t offset = size - text.size();
    const auto c = read_utf8(text);
    if (!c) {
      throw Error(source + ": byte " + std::to_string(offset) +
                  " is not UTF-8; save the text as UTF-8");
    }
    if (is_shown(*c)) {
      out.insert(*c);
    }
  }
}

std::string read_text_file(const std::filesystem::path& file,
                           const std::string& option) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw Error(file.string() + ": is a folder; give " + option + " a file");
  }
  std::ifstream in(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (!in.is_open() || in.bad()) {
    throw Error(file.string() + ": cannot be read; check the " + option);
  }
  return text;
}

void add_text_file(const std::filesystem::path& file, CharSet& out) {
  add_text(read_text_file(file, "--text-file"), file.string(), out);
}

std::string to_utf8(char32_t c) {
  const auto tail = [c](int shift) {
    return static_cast<char>(0x80 | ((c >> shift) & 0x3f));
  };
  if (c < 0x80) {
    return {static_cast<char>(c)};
  }
  if (c < 0x800) {
    return {static_cast<char>(0xc0 | c >> 6), tail(0)};
  }
  if (c < 0x10000) {
    return {static_cast<char>(0xe0 | c >> 12), tail(6), tail(0)};
  }
  return {static_cast<char>(0xf0 | c >> 18), tail(12), tail(6), tail(0)};
}

std::string describe(char32_t c) {
  char code[16];
  std::snprintf(code, sizeof code, "U+%04X", static_cast<unsigned>(c));
  return is_control(c) || is_private(c)
             ? code
             : std::string(code) + " '" + to_utf8(c) + "'";
}

}  // namespace inkcell::gen
