// A brush whose filter is gone before it is used.
// refused: deleted function
#include "inkcell/brush.hpp"

inkcell::Status make_brush(const inkcell::FilterSpec& spec,
                           inkcell::Filter& filter,
                           inkcell::Brush& brush) noexcept {
#if REFUSED
  static_cast<void>(filter);
  return inkcell::Brush::make(inkcell::Q26_6::from_int(16),
                              inkcell::make_filter(spec), brush);
#else
  filter = inkcell::make_filter(spec);
  return inkcell::Brush::make(inkcell::Q26_6::from_int(16), filter, brush);
#endif
}
