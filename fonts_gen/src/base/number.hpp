// Decimal numbers in text: of SVG, and of options.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace inkcell::gen {

/// Removes a finite number, such as +1.5e3, from the front of `text`. Without
/// one, `text` stays.
std::optional<double> take_number(std::string_view& text);

/// The numbers of a list, parted by blanks, commas or nothing; none if one of
/// them is no number.
std::optional<std::vector<double>> numbers_in(std::string_view text);

}  // namespace inkcell::gen
