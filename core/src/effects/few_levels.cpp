// Text on canvases of 1 and 2 bits, of the coverage that a filter makes.
//
// A threshold draws the pixels that are covered by half. What is thinner than a
// pixel may then show nothing; two rules draw a pixel for it:
//   - a stroke that passes a row covers about as much of it as of the rows
//     above and below: the row draws its most covered pixel; columns alike;
//   - a pixel that covers more than all eight around it, none of them drawn, is
//     the middle of a part of its own: a dot.
#include "inkcell/few_levels.hpp"

#include "base/math.hpp"
#include "effects/mixed_rows.hpp"
#include "inkcell/fit.hpp"
#include "place/style_parts.hpp"

namespace inkcell {

// Null where nothing draws outlines: see band.cpp.
extern __attribute__((weak)) const Fitter kFitTwoLevels;
extern __attribute__((weak)) const Fitter kFitFourLevels;

namespace detail {
namespace {

// What three pixels of a line across a stroke cover at least, and nine around a
// dot: more than roundings. [1/255 px]
constexpr int32_t kLeastStrokeInk = 16;
constexpr int32_t kLeastDot = 6;
// Strokes that cover so much in three pixels are no ends.
constexpr int32_t kSurely = 180;

// Coverage from which on pixels of 1 bit are drawn.
constexpr int32_t kDrawn = 128;

// What three pixels of a line cover.
int32_t ink_of_three(const uint8_t* at, int32_t step) noexcept {
  return at[-step] + *at + at[step];
}

// Whether a pixel shows most of the ink of its line, with ink in both lines
// beside it, and that is a stroke that passes the line, not an end: an end
// covers less than the strokes in the lines beside it. `step` leads along the
// line, `across` to the next one.
bool is_stroke(const uint8_t* at, int32_t step, int32_t across) noexcept {
  const int32_t own = *at;
  const int32_t here = ink_of_three(at, step);
  if (own <= at[-step] || own < at[step] || here < kLeastStrokeInk) {
    return false;
  }
  int32_t least = kSurely;
  for (int32_t i = -2; i <= 2; ++i) {
    const int32_t beside = ink_of_three(at + i * across, step);
    if ((i & 1) != 0 && 4 * beside < here) {
      return false;
    }
    least = i != 0 && 2 * beside >= here ? min(least, beside) : least;
  }
  return 4 * here >= 3 * least;
}

bool is_dot(const uint8_t* at, int32_t stride) noexcept {
  const int32_t own = *at;
  int32_t all = 0;
  int32_t earlier = 1;  // of equal pixels the first one is the dot
  const uint8_t* row = at - stride - 1;
  for (int32_t rows = 3; rows != 0; --rows) {
    for (int32_t i = 0; i != 3; ++i) {
      earlier = row + i == at ? 0 : earlier;
      if (row[i] + earlier > own) {
        return false;
      }
      all += row[i];
    }
    row += stride;
  }
  return all >= kLeastDot;
}

// Whether a pixel that is not drawn stands for ink.
__attribute__((noinline)) bool stands_for_ink(const uint8_t* at,
                                              int32_t stride) noexcept {
  return is_stroke(at, 1, stride) || is_stroke(at, stride, 1) ||
         is_dot(at, stride);
}

void mix_few(const Effect& effect, GlyphBand& band) noexcept {
  band.cover();
  const int32_t stride = band.stride();
  const uint8_t drawn =
      static_cast<const FewLevels&>(effect).levels > 2 ? 170 : 255;
  mix_rows(band, [stride, drawn](const uint8_t* at) noexcept {
    const uint8_t own = *at;
    return own != 0 && own < kDrawn && stands_for_ink(at, stride) ? drawn : own;
  });
}

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

const Mixer kFewLevelsMixer = {nullptr, plan_neighbours, mix_few};
#ifndef INKCELL_ONLY_STRIKES
const LevelRule kTwoLevelRule = {adapt, fitter_of, &kFitTwoLevels, &kTwoLevels};
const LevelRule kFourLevelRule = {adapt, fitter_of, &kFitFourLevels,
                                  &kFourLevels};
const LevelRule kShiftedTwoLevelRule = {adapt, fitter_of, &kFitTwoLevels,
                                        &kShiftedTwoLevels};
const LevelRule kShiftedFourLevelRule = {adapt, fitter_of, &kFitFourLevels,
                                         &kShiftedFourLevels};
#endif

}  // namespace detail
}  // namespace inkcell
