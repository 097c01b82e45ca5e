// Rules of canvases that dither or have another threshold.
#include "inkcell/few_levels.hpp"
#include "inkcell/port/canvas.hpp"

namespace inkcell::detail {
// Null in a program that draws no glyphs: few_levels.hpp.
extern __attribute__((weak)) const LevelRule kShiftedTwoLevelRule;
extern __attribute__((weak)) const LevelRule kShiftedFourLevelRule;
}  // namespace inkcell::detail

namespace inkcell::port::detail {

decltype(Sink::levels) shifted_two_level_rule() noexcept {
  return &inkcell::detail::kShiftedTwoLevelRule;
}
decltype(Sink::levels) shifted_four_level_rule() noexcept {
  return &inkcell::detail::kShiftedFourLevelRule;
}

}  // namespace inkcell::port::detail
