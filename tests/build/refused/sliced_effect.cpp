// An effect without its options: its mixer would read past its end.
// refused: protected
#include "inkcell/lcd.hpp"
#include "inkcell/style.hpp"

void set_lcd(inkcell::Style& style) noexcept {
  static constexpr inkcell::Lcd kLcd;
#if REFUSED
  static constexpr inkcell::Effect kCopy = kLcd;
#else
  static constexpr inkcell::Lcd kCopy = kLcd;
#endif
  style.set_effect(kCopy);
}
