#include "texts/c_escape.hpp"

#include <cstddef>

#include "source/char_set.hpp"

namespace inkcell::gen {
namespace {

// The value of a digit of any base up to 16; 99 for anything else.
unsigned digit_of(char c) {
  return c >= '0' && c <= '9'   ? static_cast<unsigned>(c - '0')
         : c >= 'a' && c <= 'f' ? static_cast<unsigned>(c - 'a') + 10
         : c >= 'A' && c <= 'F' ? static_cast<unsigned>(c - 'A') + 10
                                : 99;
}

// Reads a number of `least` to `most` digits from `begin` on.
std::optional<char32_t> read_number(std::string_view& text,
                                    size_t begin,
                                    unsigned base,
                                    size_t least,
                                    size_t most) {
  char32_t value = 0;
  size_t at = begin;
  while (at < text.size() && at - begin < most && digit_of(text[at]) < base) {
    value = value * base + digit_of(text[at]);
    ++at;
  }
  if (at - begin < least) {
    return std::nullopt;
  }
  text.remove_prefix(at);
  return value;
}

std::optional<Escape> as(std::optional<char32_t> value, bool is_unit) {
  if (!value) {
    return std::nullopt;
  }
  return Escape{*value, is_unit};
}

}  // namespace

std::optional<Escape> read_escape(std::string_view& text) {
  if (text.empty()) {
    return std::nullopt;
  }
  switch (text[0]) {
    case 'x':
      return as(read_number(text, 1, 16, 1, 8), true);
    case 'u':
      return as(read_number(text, 1, 16, 4, 4), false);
    case 'U':
      return as(read_number(text, 1, 16, 8, 8), false);
    default:
      break;
  }
  if (digit_of(text[0]) < 8) {
    return as(read_number(text, 0, 8, 1, 3), true);
  }
  constexpr std::string_view kLetters = "abfnrtv\\'\"?";
  constexpr std::string_view kValues = "\a\b\f\n\r\t\v\\'\"?";
  const size_t found = kLetters.find(text[0]);
  if (found == std::string_view::npos) {
    return std::nullopt;
  }
  text.remove_prefix(1);
  return Escape{static_cast<char32_t>(kValues[found]), false};
}

std::string bytes_of(const Escape& escape) {
  return escape.is_unit ? std::string(1, static_cast<char>(escape.value))
                        : to_utf8(escape.value);
}

}  // namespace inkcell::gen
