// A Status that nobody looks at.
// refused: nodiscard|unused-result
#include "inkcell/style.hpp"

inkcell::Status make_style(inkcell::Style& style) noexcept {
#if REFUSED
  inkcell::Style::make(inkcell::Q26_6::from_int(16), inkcell::kFilterText,
                       style);
  return inkcell::Status::ok;
#else
  return inkcell::Style::make(inkcell::Q26_6::from_int(16),
                              inkcell::kFilterText, style);
#endif
}
