// A line of text to be shaped.
#pragma once

#include <string>

namespace inkcell::gen {

/// The direction of a line; from_text: that of the first letter with a
/// direction.
enum class LineDirection { from_text, left_to_right, right_to_left };

/// A line in logical order, without control characters.
struct LineText {
  std::u32string text;
  std::string language;  // BCP 47, such as "ar" or "zh-Hant"; may be empty
  LineDirection direction = LineDirection::from_text;
};

}  // namespace inkcell::gen
