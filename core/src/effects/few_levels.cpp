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

namespace inkcell {

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

}  // namespace

const Mixer kFewLevelsMixer = {nullptr, plan_neighbours, mix_few};

}  // namespace detail
}  // namespace inkcell
