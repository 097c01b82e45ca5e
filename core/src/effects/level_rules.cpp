// Which styles text has on canvases of 1 and 2 bits. Apart from the effect,
// which programs name that have no outlines: see band.cpp.
#include "inkcell/few_levels.hpp"

#include "inkcell/fit.hpp"
#include "place/style_parts.hpp"

#ifndef INKCELL_ONLY_STRIKES
namespace inkcell {

// Null where nothing draws outlines.
extern __attribute__((weak)) const Fitter kFitTwoLevels;
extern __attribute__((weak)) const Fitter kFitFourLevels;

namespace detail {
namespace {

// A rule's own fitter is null in a program without outlines.
const Fitter* fitter_of(const LevelRule& rule,
                        const Style& given,
                        bool can_fit) noexcept {
  if (!StyleParts::is_fit_open(given)) {
    return given.fitter();
  }
  return can_fit && given.size().raw < Fit::kEnds.raw ? rule.own : nullptr;
}

const Style& adapt(const LevelRule& rule,
                   const Style& given,
                   bool can_fit,
                   Style& room) noexcept {
  const bool is_open = StyleParts::is_fit_open(given);
  if (!is_open && given.effect() != nullptr) {
    return given;
  }
  room = given;
  if (is_open) {
    const Fitter* const fitter = fitter_of(rule, given, can_fit);
    fitter == nullptr ? room.clear_fit() : room.set_fit(*fitter, nullptr);
  }
  if (given.effect() == nullptr) {
    room.set_effect(*rule.effect);
  }
  return room;
}

}  // namespace

const LevelRule kTwoLevelRule = {adapt, fitter_of, &kFitTwoLevels, &kTwoLevels};
const LevelRule kFourLevelRule = {adapt, fitter_of, &kFitFourLevels,
                                  &kFourLevels};
const LevelRule kShiftedTwoLevelRule = {adapt, fitter_of, &kFitTwoLevels,
                                        &kShiftedTwoLevels};
const LevelRule kShiftedFourLevelRule = {adapt, fitter_of, &kFitFourLevels,
                                         &kShiftedFourLevels};

}  // namespace detail
}  // namespace inkcell
#endif
