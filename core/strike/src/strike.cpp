#include "inkcell/strike/strike.hpp"

#include "find_picture.hpp"
#include "inkcell/few_levels.hpp"
#include "inkcell/format/rom.hpp"
#include "inkcell/painter.hpp"
#include "rows/source.hpp"
#include "rows/strike_scale.hpp"

namespace inkcell {
namespace detail {
namespace {

// The font, or page of one, in which a glyph lies; sets its id there, and the
// scale. Null: the style does not draw the font, or there is no such glyph.
const Font* find_page(const Font& font,
                      const Style& style,
                      PictureCall& call) noexcept {
  call.scale = strike_scale(font, style);
  return call.scale == 0 ? nullptr : font.page_of(call.glyph);
}

// For boxes.
bool prepare_strike(GlyphJob& job,
                    const GlyphRef& ref,
                    const Placed& placed) noexcept {
  PictureCall call = {kAnyKey, ref.glyph, 0, placed};
  Picture picture;
  const Font* const page =
      find_page(*static_cast<const Font*>(ref.from), *job.style, call);
  if (page == nullptr || !StrikeAlone::find_picture(*page, call, picture)) {
    return false;
  }
  job.box = picture.box;
  return true;
}

// By kBits, strikes of 1 bit alone.
template <bool kBits>
void draw_strike(GlyphRun& run, uint16_t glyph, const Placed& placed) noexcept {
  const Style& style = *run.style;
  const Sink& sink = run.painter.sink();
  PictureCall call = {kBits ? kBitKey : kAnyKey, glyph, 0, placed};
  const Font* const page = find_page(*run.font, style, call);
  // Canvases of few levels set an effect.
  const Effect* const effect = style.effect();
  const bool has_no_effect =
      effect == nullptr ||
      (sink.levels != nullptr && effect == sink.levels->effect);
  // Bytes that change may change the size that the font has, too.
  INKCELL_ASSERT(is_plain(style) && has_no_effect);
  Picture picture;
  if (page != nullptr && has_no_effect &&
      StrikeAlone::find_picture(*page, call, picture)) {
    draw_in_window(picture, kBits ? draw_bits : draw_picture, sink);
  }
}

template <bool kBits>
constexpr Source kStrikeSource = {
    prepare_strike,      nullptr,           nullptr, 0,
    SourceKind::strikes, draw_strike<kBits>};

}  // namespace
}  // namespace detail

const Coding kStrikeCoding = {static_cast<uint8_t>(format::Coding::strike),
                              &detail::kStrikeSource<false>};
const Coding kBitStrikeCoding = {static_cast<uint8_t>(format::Coding::strike),
                                 &detail::kStrikeSource<true>};

}  // namespace inkcell
