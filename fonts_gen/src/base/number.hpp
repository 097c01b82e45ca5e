// Decimal numbers in text: of SVG, and of options.
#pragma once

#include <optional>
#include <string_view>

namespace inkcell::gen {

/// Removes a finite number, such as +1.5e3, from the front of `text`. Without
/// one, `text` stays.
std::optional<double> take_number(std::string_view& text);

/// The same where the standard library reads no floating-point numbers by
/// std::from_chars.
std::optional<double> take_number_by_strtod(std::string_view& text);

}  // namespace inkcell::gen
