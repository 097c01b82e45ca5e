// A Status that nobody looks at.
// refused: nodiscard|unused-result
#include "inkcell/brush.hpp"

inkcell::Status make_brush(inkcell::Brush& brush) noexcept {
#if REFUSED
  inkcell::Brush::make(inkcell::Q26_6::from_int(16), inkcell::kFilterText,
                       brush);
  return inkcell::Status::ok;
#else
  return inkcell::Brush::make(inkcell::Q26_6::from_int(16),
                              inkcell::kFilterText, brush);
#endif
}
