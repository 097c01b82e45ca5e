// Widths of glyphs in the unit in which a style adds them up: whole pixels, or
// the font's units.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "inkcell/font.hpp"
#include "inkcell/style.hpp"
#include "rows/outline_source.hpp"

namespace inkcell::detail {

// Longer lines than this, 1000 em at the least, end where it ends: a hostile
// font may have glyphs 65535 units wide.
inline constexpr int32_t kMaxUnits = 1 << 24;

// The same of lines of whole pixels.
inline constexpr int32_t kMaxPx = 1 << 18;

inline int32_t clamp_to(int64_t value, int32_t limit) noexcept {
  return clamp_i64(value, -limit, limit);
}

// A font, a style, and its fitter if that has advances in whole pixels, or
// null.
class Advances {
 public:
  Advances(const Font& font, const Style* style, const Fitter* whole) noexcept
      : font_(font), style_(style), fitter_(whole) {}

  bool is_whole() const noexcept { return fitter_ != nullptr; }
  int32_t limit() const noexcept { return is_whole() ? kMaxPx : kMaxUnits; }

  // Not inline, like join() and to_units(), for their size.
  __attribute__((noinline)) int32_t advance(uint16_t glyph) const noexcept {
    return is_whole() ? fitter_->advance_px(font_, *style_, glyph)
                      : font_.advance(glyph);
  }
  // Between two glyphs. `drift_q6`: of OutlineFitter, 0 where a run begins.
  // Inline: one frame less on the deepest stack of layout.
  int32_t kerning(uint16_t left,
                  uint16_t right,
                  int32_t& drift_q6) const noexcept {
    const int32_t units = font_.kerning(left, right);
    return is_whole() ? join({left, right, units}, drift_q6) : units;
  }

  // Whole pixels between two glyphs.
  __attribute__((noinline)) int32_t join(const GlyphPair& pair,
                                         int32_t& drift_q6) const noexcept {
    return fitter_->outlines->join(font_, *style_, *fitter_, pair, drift_q6);
  }

  // A sum of them in font units, to the nearest. At most limit() in magnitude.
  __attribute__((noinline)) int32_t to_units(int32_t sum) const noexcept {
    return !is_whole() ? sum
                       : clamp_to(fitter_->outlines->to_units(
                                      font_, style_->size(), sum),
                                  kMaxUnits);
  }

 private:
  const Font& font_;
  const Style* style_;  // may be null where there is no fitter
  const Fitter* fitter_;
};

}  // namespace inkcell::detail
