// A box of text whose style is gone before it is drawn.
// refused: deleted (function|constructor)
#include "inkcell/layout/text_box.hpp"

inkcell::TextBox make_box(const inkcell::Font& font,
                          const inkcell::Style& style) noexcept {
#if REFUSED
  return inkcell::TextBox(font, inkcell::Style(style), {0, 0, 90, 20});
#else
  return inkcell::TextBox(font, style, {0, 0, 90, 20});
#endif
}
