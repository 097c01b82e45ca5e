// A style whose filter is gone before it is used.
// refused: deleted (function|constructor)
#include "inkcell/style.hpp"

inkcell::Style make_style(const inkcell::FilterSpec& spec,
                          inkcell::Filter& filter) noexcept {
#if REFUSED
  static_cast<void>(filter);
  return inkcell::Style(inkcell::Q26_6::from_int(16),
                        inkcell::make_filter(spec));
#else
  filter = inkcell::make_filter(spec);
  return inkcell::Style(inkcell::Q26_6::from_int(16), filter);
#endif
}
