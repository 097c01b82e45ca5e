// A morph for each letter, made when it is drawn.
#include "inkcell/motion/weight_pulse.hpp"

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

// By what a letter is wider than in plain text. [px, Q6]
int32_t growth(const OutlineMorph& morph,
               const Style& style,
               Q16_16 progress) noexcept {
  return morph.advance(style, progress).raw -
         morph.advance(style, Q16_16()).raw;
}

}  // namespace

WeightPulse::WeightPulse(const Font& font,
                         const Style& style,
                         Point origin,
                         Text text,
                         const PulseMotion& motion) noexcept
    : face_{&font, &style}, origin_(origin), text_(text), motion_(motion) {
  TextCursor cursor(font, text);
  PositionedGlyph glyph;
  while (cursor.next(glyph)) {
    ++letters_;
  }
}

Q16_16 WeightPulse::progress(size_t letter, int32_t now_ms) const noexcept {
  constexpr int32_t kMostMs = 1 << 30;
  const int64_t time =
      int64_t{now_ms} - delay_of(motion_.stagger, letter, letters_);
  const int32_t local =
      local_time(motion_.timing, clamp_i64(time, -kMostMs, kMostMs));
  const int32_t top = motion_.swell_ms / 2;
  return ease(kEaseInOut,
              local < top ? fraction(0, top, local)
                          : Q16_16::from_raw(
                                (1 << 16) -
                                fraction(top, motion_.swell_ms, local).raw));
}

Point WeightPulse::place(const PositionedGlyph& glyph,
                         int32_t grown_q6) const noexcept {
  const auto px = [this](int32_t units) {
    return to_px(*face_.font, *face_.style, units).raw;
  };
  return {Q26_6::from_raw(origin_.x.raw + px(glyph.x) + grown_q6),
          Q26_6::from_raw(origin_.y.raw - px(glyph.y))};
}

Rect WeightPulse::at(int32_t now_ms) noexcept {
  const Style& style = *face_.style;
  const int32_t times[] = {now_ms, now_ms_};
  int32_t grown_q6[] = {0, 0};
  Rect changed;
  TextCursor cursor(*face_.font, text_);
  PositionedGlyph glyph;
  for (size_t i = 0; cursor.next(glyph); ++i) {
    const OutlineMorph morph =
        OutlineMorph::to_master(*face_.font, glyph.glyph);
    const bool can_morph = morph.from() != morph.to();
    Q16_16 parts[2];
    for (int32_t k = 0; k < 2 && can_morph; ++k) {
      parts[k] = progress(i, times[k]);
    }
    const bool is_still =
        is_drawn_ && parts[0].raw == parts[1].raw && grown_q6[0] == grown_q6[1];
    for (int32_t k = 0; k < 2; ++k) {
      if (!is_still && (k == 0 || is_drawn_)) {
        changed = bounding_box(
            changed, morph.box(style, place(glyph, grown_q6[k]), parts[k]));
      }
      grown_q6[k] += growth(morph, style, parts[k]);
    }
  }
  now_ms_ = now_ms;
  is_drawn_ = true;
  return changed;
}

void WeightPulse::draw(const Painter& painter) const noexcept {
  const Font& font = *face_.font;
  const bool has_room =
      OutlineMorph::workspace_bytes(font) <= painter.ram().size;
  int32_t grown_q6 = 0;
  TextCursor cursor(font, text_);
  PositionedGlyph glyph;
  for (size_t i = 0; cursor.next(glyph); ++i) {
    const OutlineMorph morph = OutlineMorph::to_master(font, glyph.glyph);
    const Q16_16 part = has_room ? progress(i, now_ms_) : Q16_16();
    morph.draw(painter, *face_.style, place(glyph, grown_q6), part);
    grown_q6 += growth(morph, *face_.style, part);
  }
}

}  // namespace inkcell::motion
