#include "base/number.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace inkcell::gen {
namespace {

// How many digits `text` has from `at` on.
size_t digits_from(std::string_view text, size_t at) {
  const size_t end = text.find_first_not_of("0123456789", at);
  return at >= text.size() ? 0 : std::min(end, text.size()) - at;
}

// The length of a decimal number at the front of `text`; 0: there is none.
size_t number_length(std::string_view text) {
  size_t at = !text.empty() && text[0] == '-' ? 1 : 0;
  const size_t whole = digits_from(text, at);
  at += whole;
  size_t part = 0;
  if (at < text.size() && text[at] == '.') {
    part = digits_from(text, at + 1);
    at += 1 + part;
  }
  if (whole + part == 0) {
    return 0;
  }
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    const std::string_view signs = "+-";
    const size_t first =
        at + 1 < text.size() && signs.find(text[at + 1]) != signs.npos ? 2 : 1;
    const size_t exponent = digits_from(text, at + first);
    at += exponent == 0 ? 0 : first + exponent;
  }
  return at;
}

}  // namespace

std::optional<double> take_number(std::string_view& text) {
  const size_t sign = !text.empty() && text[0] == '+' ? 1 : 0;
  const size_t length = number_length(text.substr(sign));
  // Not std::from_chars(), which the library of macOS has for integers only.
  const std::string number(text.substr(sign, length));
  const double value = std::strtod(number.c_str(), nullptr);
  if (length == 0 || !std::isfinite(value)) {
    return std::nullopt;
  }
  text.remove_prefix(sign + length);
  return value;
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    text.remove_prefix(
        std::min(text.find_first_not_of(" \t\r\n,"), text.size()));
    if (text.empty()) {
      return numbers;
    }
    const std::optional<double> value = take_number(text);
    if (!value) {
      return std::nullopt;
    }
    numbers.push_back(*value);
  }
}

}  // namespace inkcell::gen
