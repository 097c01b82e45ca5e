// Which strike draws a glyph, if one does.
#include "inkcell/strike/strike.hpp"

#include "base/math.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/painter.hpp"
#include "picture.hpp"
#include "place/position.hpp"
#include "rows/outline_source.hpp"
#include "rows/strike_scale.hpp"

namespace inkcell {
namespace detail {
namespace {

using DrawPicture = decltype(draw_picture);
using format::StrikeFit;

// The first word of an entry.
constexpr uint32_t kBitsMask = 0x00ff0000;
constexpr uint32_t entry_word(int32_t px,
                              uint32_t bits,
                              StrikeFit fit) noexcept {
  return static_cast<uint32_t>(px) | bits << 16 |
         static_cast<uint32_t>(fit) << 24;
}

int32_t nearest_px(int32_t at_q10) noexcept {
  return (at_q10 + 512) >> 10;
}

bool draw_found(const Span<const uint8_t>& strikes,
                const StrikeKey& key,
                uint32_t glyph,
                const Placed& placed,
                int32_t scale,
                const Sink& sink,
                DrawPicture* draw) noexcept {
  Picture picture;
  if (!find_picture(strikes, key, glyph, picture)) {
    return false;
  }
  const Rect box = box_of(picture, nearest_px(placed.x_q10),
                          nearest_px(placed.y_q10), scale);
  if (!is_empty(intersect(box, sink.window))) {
    draw(picture, box, scale, sink);
  }
  return true;
}

// Fonts of strikes alone.

bool prepare_strike(GlyphJob& job,
                    const GlyphRef& ref,
                    const Placed& placed) noexcept {
  uint32_t glyph = ref.glyph;
  const Font* const font = static_cast<const Font*>(ref.from)->page_of(glyph);
  if (font == nullptr) {
    return false;
  }
  const int32_t scale = strike_scale(*font, *job.style);
  Picture picture;
  if (scale == 0 ||
      !find_picture(font->glyph_table(), {0, 0}, glyph, picture)) {
    return false;
  }
  job.box = box_of(picture, nearest_px(placed.x_q10), nearest_px(placed.y_q10),
                   scale);
  return true;
}

template <DrawPicture* kDraw>
void draw_strike(GlyphRun& run, uint16_t id, const Placed& placed) noexcept {
  const Style& style = *run.style;
  const Sink& sink = run.painter.sink();
  uint32_t glyph = id;
  const Font* const font = run.font->page_of(glyph);
  const Effect* const effect = style.effect();
  // Canvases of few levels set an effect.
  if (font == nullptr ||
      (effect != nullptr &&
       (sink.levels == nullptr || effect != sink.levels->effect))) {
    INKCELL_ASSERT(font == nullptr);
    return;
  }
  const int32_t scale = strike_scale(*font, style);
  INKCELL_ASSERT(scale != 0);
  if (scale != 0) {
    constexpr bool kHasGreys = kDraw == draw_picture;
    constexpr StrikeKey kKey = {kHasGreys ? 0 : kBitsMask,
                                kHasGreys ? 0 : 1 << 16};
    draw_found(font->glyph_table(), kKey, glyph, placed, scale, sink, kDraw);
  }
}

// Strikes beside outlines.

// The strikes that show what a style draws from outlines into a sink, as the
// word of their entries. False: none do.
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
    if (style.effect() != nullptr) {
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

// What lies in a font from its strikes on; nothing, if it has none. The run
// keeps where, unless its state is another's.
Span<const uint8_t> strikes_of(GlyphRun& run) noexcept {
  const Span<const uint8_t> rom = run.font->rom();
  uint32_t offset = run.state;
  if (offset < format::header::kBytes) {
    const Span<const uint8_t> found =
        run.font->section(format::section::kStrikes);
    offset = found.size == 0 ? format::section::kOffsetMask
                             : static_cast<uint32_t>(found.data - rom.data);
    run.state = run.state == 0 ? offset : run.state;
  }
  return offset < rom.size
             ? Span<const uint8_t>{rom.data + offset, rom.size - offset}
             : Span<const uint8_t>{};
}

template <DrawPicture* kDraw>
void draw_either(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept {
  const Sink& sink = run.painter.sink();
  constexpr bool kHasGreys = kDraw == draw_picture;
  uint32_t word;
  if (find_word(*run.style, sink, word) &&
      (kHasGreys || (word & kBitsMask) == 1 << 16) &&
      // Fitters bring glyphs to whole pixels.
      (word >> 24 != static_cast<uint32_t>(StrikeFit::none) ||
       ((placed.x_q10 | placed.y_q10) & 1023) == 0) &&
      draw_found(strikes_of(run), {~uint32_t{0}, word}, glyph, placed, 1, sink,
                 kDraw)) {
    return;
  }
  draw_banded(run, glyph, placed);
}

template <DrawPicture* kDraw>
constexpr Source kStrikeSource = {
    prepare_strike,      nullptr,           nullptr, 0,
    SourceKind::strikes, draw_strike<kDraw>};
template <DrawPicture* kDraw>
constexpr Source kEitherSource = outline_source(draw_either<kDraw>);

}  // namespace
}  // namespace detail

const Coding kStrikeCoding = {static_cast<uint8_t>(format::Coding::strike),
                              &detail::kStrikeSource<detail::draw_picture>};
const Coding kBitStrikeCoding = {static_cast<uint8_t>(format::Coding::strike),
                                 &detail::kStrikeSource<detail::draw_bits>};
const Coding kOutlineStrikeCoding = {
    static_cast<uint8_t>(format::Coding::outline),
    &detail::kEitherSource<detail::draw_picture>};
const Coding kOutlineBitStrikeCoding = {
    static_cast<uint8_t>(format::Coding::outline),
    &detail::kEitherSource<detail::draw_bits>};

}  // namespace inkcell
