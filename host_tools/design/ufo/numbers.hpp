// Numbers as text: the fewest digits that read back as the same number.
#pragma once

#include <charconv>
#include <cmath>
#include <string>

namespace inkcell::design {

/// 12, -0.5, 1e+30. A number without fraction has no decimal point.
inline std::string to_text(double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits,
                                 value == 0 ? 0.0 : value);  // no -0
  return std::string(digits, end.ptr);
}

}  // namespace inkcell::design
