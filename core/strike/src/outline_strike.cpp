#include "inkcell/strike/outline_strike.hpp"

#include "inkcell/few_levels.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/painter.hpp"
#include "picture.hpp"
#include "rows/outline_source.hpp"
#include "rows/strike_scale.hpp"

#ifndef INKCELL_ONLY_STRIKES
namespace inkcell {
namespace detail {
namespace {

using format::StrikeFit;

// The first word of an entry.
constexpr uint32_t entry_word(int32_t px,
                              uint32_t bits,
                              StrikeFit fit) noexcept {
  return static_cast<uint32_t>(px) | bits << 16 |
         static_cast<uint32_t>(fit) << 24;
}

// The strikes that show what a style draws from outlines into a sink, as the
// word of their entries. False: none do.
template <bool kBits>
bool find_word(const Style& style, const Sink& sink, uint32_t& word) noexcept {
  const int32_t size_q6 = style.size().raw;
  if (!is_plain(style) || (size_q6 & 63) != 0) {
    return false;
  }
  const Fitter* const fitter = style.fitter();
  const LevelRule* const rule = sink.levels;
  uint32_t bits = 4;
  StrikeFit fit = StrikeFit::none;
  if (rule != nullptr) {
    if (style.effect() != rule->effect) {
      return false;
    }
    bits = rule->effect->strike_bits;
    fit = fitter == rule->own ? StrikeFit::both : StrikeFit::source;
  } else {
    if (kBits || style.effect() != nullptr) {
      return false;
    }
    fit = style.fit_options() == &kBothMark      ? StrikeFit::both
          : style.fit_options() == &kHeightsMark ? StrikeFit::heights
                                                 : StrikeFit::source;
  }
  // Larger glyphs are not fitted.
  if (fitter == nullptr || size_q6 >= Fit::kEnds.raw) {
    fit = StrikeFit::none;
  }
  word = entry_word(size_q6 >> 6, bits, fit);
  return fit != StrikeFit::source;
}

// By kBits, strikes of 1 bit alone.
template <bool kBits>
void draw_either(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept {
  const Sink& sink = run.painter.sink();
  uint32_t word;
  if (find_word<kBits>(*run.style, sink, word) &&
      (!kBits || (word & kBitsMask) == kBitKey.word) &&
      // Fitters bring glyphs to whole pixels.
      (word >> 24 != static_cast<uint32_t>(StrikeFit::none) ||
       ((placed.x_q10 | placed.y_q10) & 1023) == 0) &&
      draw_found(run.font->section(format::section::kStrikes),
                 {{~uint32_t{0}, word}, glyph, 1, placed},
                 kBits ? draw_bits_as_is : draw_picture_as_is, sink)) {
    return;
  }
  draw_banded(run, glyph, placed);
}

template <bool kBits>
constexpr Source kEitherSource = outline_source(draw_either<kBits>);

}  // namespace
}  // namespace detail

const Coding kOutlineStrikeCoding = {
    static_cast<uint8_t>(format::Coding::outline),
    &detail::kEitherSource<false>};
const Coding kOutlineBitStrikeCoding = {
    static_cast<uint8_t>(format::Coding::outline),
    &detail::kEitherSource<true>};

}  // namespace inkcell
#endif
