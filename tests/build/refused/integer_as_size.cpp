// A whole number where 1/64 px are meant.
// refused: could not convert|no matching function|cannot convert
#include "inkcell/style.hpp"

inkcell::Status make_style(inkcell::Style& style) noexcept {
#if REFUSED
  return inkcell::Style::make(16, inkcell::kFilterText, style);
#else
  return inkcell::Style::make(inkcell::Q26_6::from_int(16),
                              inkcell::kFilterText, style);
#endif
}
