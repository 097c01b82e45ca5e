// A style whose effect is gone before it is used.
// refused: deleted (member )?function
#include "inkcell/stroke.hpp"
#include "inkcell/style.hpp"

void set_stroke(inkcell::Style& style) noexcept {
  constexpr inkcell::Q6_10 kWidth = inkcell::Q6_10::from_int(1);
#if REFUSED
  style.set_effect(inkcell::Stroke(inkcell::kFilterText, kWidth));
#else
  static constexpr inkcell::Stroke kStroke(inkcell::kFilterText, kWidth);
  style.set_effect(kStroke);
#endif
}
