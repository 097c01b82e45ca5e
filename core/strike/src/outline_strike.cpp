#include "inkcell/strike/outline_strike.hpp"

#include "find_picture.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/painter.hpp"
#include "rows/outline_source.hpp"
#include "rows/strike_scale.hpp"

#ifndef INKCELL_ONLY_STRIKES
namespace inkcell {
namespace detail {
namespace {

using format::StrikeFit;

// The strikes that show what a style draws from outlines into a sink, as the
// first word of their entries. By kBits, those of 1 bit alone. False: none do.
template <bool kBits>
bool find_word(const Style& style, const Sink& sink, uint32_t& word) noexcept {
  const int32_t size_q6 = style.size().raw;
  if (!is_plain(style) || (size_q6 & 63) != 0) {
    return false;
  }
  const Fitter* const fitter = style.fitter();
  const LevelRule* const rule = sink.levels;
  uint32_t bits = 4;
  // No font has strikes of this fit beside outlines.
  StrikeFit fit = StrikeFit::source;
  if (rule != nullptr) {
    bits = rule->effect->strike_bits;
    if (style.effect() != rule->effect || (kBits && bits != 1)) {
      return false;
    }
    if (fitter == rule->own) {
      fit = StrikeFit::both;
    }
  } else {
    if (kBits || style.effect() != nullptr) {
      return false;
    }
    if (style.fit_options() == &kBothMark) {
      fit = StrikeFit::both;
    } else if (style.fit_options() == &kHeightsMark) {
      fit = StrikeFit::heights;
    }
  }
  // Larger glyphs are not fitted.
  if (fitter == nullptr || size_q6 >= Fit::kEnds.raw) {
    fit = StrikeFit::none;
  }
  word = static_cast<uint32_t>(size_q6) >> 6 | bits << 16 |
         static_cast<uint32_t>(fit) << 24;
  return true;
}

// Finds and draws. Not inline: what it takes of the stack is free again when
// outlines are drawn. False: there is no picture.
__attribute__((noinline)) bool draw_found(const Span<const uint8_t>& strikes,
                                          const PictureCall& call,
                                          DrawPicture* draw,
                                          const Sink& sink) noexcept {
  Picture picture;
  if (!find_picture(strikes, call, picture)) {
    return false;
  }
  draw_in_window(picture, draw, sink);
  return true;
}

template <bool kBits>
void draw_either(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept {
  const Sink& sink = run.painter.sink();
  uint32_t word;
  if (find_word<kBits>(*run.style, sink, word) &&
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
