// A whole number where 1/64 px are meant.
// refused: could not convert|no matching function|cannot convert
#include "inkcell/text_style.hpp"

inkcell::Status make_style(inkcell::TextStyle& style) noexcept {
#if REFUSED
  return inkcell::TextStyle::make(16, inkcell::kFilterText, style);
#else
  return inkcell::TextStyle::make(inkcell::Q26_6::from_int(16),
                                  inkcell::kFilterText, style);
#endif
}
