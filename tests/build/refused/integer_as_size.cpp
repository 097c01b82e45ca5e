// A whole number where 1/64 px are meant.
// refused: could not convert|no matching function|cannot convert
#include "inkcell/brush.hpp"

inkcell::Status make_brush(inkcell::Brush& brush) noexcept {
#if REFUSED
  return inkcell::Brush::make(16, inkcell::kFilterText, brush);
#else
  return inkcell::Brush::make(inkcell::Q26_6::from_int(16),
                              inkcell::kFilterText, brush);
#endif
}
