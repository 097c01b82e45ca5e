// A Status that nobody looks at.
// refused: nodiscard|unused-result
#include "inkcell/text_style.hpp"

inkcell::Status make_style(inkcell::TextStyle& style) noexcept {
#if REFUSED
  inkcell::TextStyle::make(inkcell::Q26_6::from_int(16), inkcell::kFilterText,
                           style);
  return inkcell::Status::ok;
#else
  return inkcell::TextStyle::make(inkcell::Q26_6::from_int(16),
                                  inkcell::kFilterText, style);
#endif
}
