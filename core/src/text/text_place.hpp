// Where the glyphs of a run stand, in px.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "inkcell/font.hpp"
#include "inkcell/style.hpp"
#include "inkcell/text.hpp"
#include "outlines/slant.hpp"
#include "place/position.hpp"
#include "place/style_parts.hpp"
#include "text/advances.hpp"

namespace inkcell::detail {

// What a run's font units are in px: computed once, because it takes a
// division. [px per unit, Q10 with 20 more bits]
class UnitScale {
 public:
  UnitScale(const Font& font, const Style& style) noexcept {
    // 2^24 sizes over the em, to the nearest: 14 bits, then what is left and 10
    // more, so that 32 are enough.
    const uint32_t em = font.units_per_em();
    const uint32_t size_q20 = static_cast<uint32_t>(style.size().raw) << 14;
    const uint32_t whole = size_q20 / em;
    const uint32_t rest = size_q20 - whole * em;
    scale_ = (int64_t{whole} << 10) + ((rest << 10) + em / 2) / em;
  }

  // At most 2^24 units times 2^36: within int64_t. Both roundings are to the
  // nearest, so that whole pixels are met exactly.
  // Not inline for its size.
  __attribute__((noinline)) int64_t to_px_q10(int32_t units) const noexcept {
    if (units == 0) {
      return 0;  // most glyphs stand on the baseline
    }
    return (clamp_to(units, kMaxUnits) * scale_ + (1 << 19)) >> 20;
  }

 private:
  int64_t scale_;
};

// False: the glyph is too far away. Not inline: what it takes of the stack is
// free again when the glyph is drawn.
__attribute__((noinline)) inline bool place_near(const UnitScale& scale,
                                                 const Style& style,
                                                 const Point& origin,
                                                 const PositionedGlyph& at,
                                                 Placed& out) noexcept {
  const int64_t along = scale.to_px_q10(at.x);
  const int64_t across = scale.to_px_q10(at.y);
  const FinePoint from = origin;
  return out.set(
      style.is_upright()
          ? FinePoint(from.x_q10 + along, from.y_q10 - across)
          : StyleParts::slant(style).place(style, from, along, across));
}

// Ink that is not there yet, to add() to.
inline constexpr TextMeasure kNoInk = {0, INT32_MAX, INT32_MAX, INT32_MIN,
                                       INT32_MIN};

inline void add_ink(const Font& font,
                    const PositionedGlyph& at,
                    TextMeasure& sum) noexcept {
  GlyphMetrics ink;
  if (font.glyph_metrics(at.glyph, ink) == Status::ok &&
      ink.x_max > ink.x_min) {
    sum.x_min = min(sum.x_min, at.x + ink.x_min);
    sum.x_max = max(sum.x_max, at.x + ink.x_max);
    sum.y_min = min(sum.y_min, at.y + ink.y_min);
    sum.y_max = max(sum.y_max, at.y + ink.y_max);
  }
}

// The nearest whole pixel. Far away it may wrap, but not to where it would be
// seen.
inline Q26_6 whole_px(Q26_6 x) noexcept {
  const uint32_t sum = static_cast<uint32_t>(x.raw) + 32;
  return Q26_6::from_raw(static_cast<int32_t>(sum & ~uint32_t{63}));
}

}  // namespace inkcell::detail
