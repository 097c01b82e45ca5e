#include "base/number.hpp"

#include <algorithm>
#include <charconv>
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

// Puts the rest of `text` behind a number in place, if it is finite.
std::optional<double> taken(std::string_view& text,
                            size_t length,
                            double value) {
  if (length == 0 || !std::isfinite(value)) {
    return std::nullopt;
  }
  text.remove_prefix(length);
  return value;
}

size_t sign_length(std::string_view text) {
  return !text.empty() && text[0] == '+' ? 1 : 0;
}

}  // namespace

std::optional<double> take_number_by_strtod(std::string_view& text) {
  const size_t sign = sign_length(text);
  const size_t length = number_length(text.substr(sign));
  const std::string number(text.substr(sign, length));
  return taken(text, length == 0 ? 0 : sign + length,
               std::strtod(number.c_str(), nullptr));
}

std::optional<double> take_number(std::string_view& text) {
#ifdef __cpp_lib_to_chars
  double value = 0;
  const auto [end, error] = std::from_chars(text.data() + sign_length(text),
                                            text.data() + text.size(), value);
  return taken(
      text,
      error == std::errc() ? static_cast<size_t>(end - text.data()) : size_t{0},
      value);
#else
  return take_number_by_strtod(text);
#endif
}

}  // namespace inkcell::gen
