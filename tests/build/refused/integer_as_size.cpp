// A whole number where 1/64 px are meant.
// refused: could not convert|no matching (function|constructor)|cannot convert
#include "inkcell/style.hpp"

inkcell::Style make_style() noexcept {
#if REFUSED
  return inkcell::Style(16, inkcell::kFilterText);
#else
  return inkcell::Style(inkcell::Q26_6::from_int(16), inkcell::kFilterText);
#endif
}
