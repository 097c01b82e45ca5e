// A value whose style is gone before it is drawn.
// refused: deleted (function|constructor)
#include "inkcell/value_label.hpp"

inkcell::ValueLabel make_value(const inkcell::Font& font,
                               const inkcell::Style& style) noexcept {
#if REFUSED
  return inkcell::ValueLabel(font, inkcell::Style(style), {4, 28});
#else
  return inkcell::ValueLabel(font, style, {4, 28});
#endif
}
