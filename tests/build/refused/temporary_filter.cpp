// A style whose filter is gone before it is used.
// refused: deleted function
#include "inkcell/style.hpp"

inkcell::Status make_style(const inkcell::FilterSpec& spec,
                           inkcell::Filter& filter,
                           inkcell::Style& style) noexcept {
#if REFUSED
  static_cast<void>(filter);
  return inkcell::Style::make(inkcell::Q26_6::from_int(16),
                              inkcell::make_filter(spec), style);
#else
  filter = inkcell::make_filter(spec);
  return inkcell::Style::make(inkcell::Q26_6::from_int(16), filter, style);
#endif
}
