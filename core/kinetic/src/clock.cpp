// All digits of a change move together: between both times no third one shows.
#include "inkcell/kinetic/clock.hpp"

#include "inkcell/kinetic/easing.hpp"
#include "inkcell/kinetic/outline_morph.hpp"
#include "inkcell/kinetic/timeline.hpp"
#include "limits.hpp"

namespace inkcell {
namespace kinetic {
namespace {

constexpr uint32_t kMinutesPerDay = 24 * 60;
constexpr Easing kChange = cubic_bezier(650, 0, 350, 1000);

uint32_t digit_of(uint32_t minute, int32_t digit) noexcept {
  switch (digit) {
    case 0:
      return minute / 600;
    case 1:
      return minute / 60 % 10;
    case 2:
      return minute / 10 % 6;
    default:
      return minute % 10;
  }
}

Q16_16 part_at(int32_t since_ms) noexcept {
  return ease(kChange, fraction(0, Clock::kEndMs, since_ms));
}

}  // namespace

Clock::Clock(const Font& font, const Style& style, Point origin) noexcept
    : face_{&font, &style},
      origin_(origin),
      cells_(measure_digits(font, style)),
      colon_(to_px(font, style, font.advance(font.glyph_or_notdef(':')))) {}

Q26_6 Clock::left_of(int32_t digit) const noexcept {
  return Q26_6::from_raw(origin_.x.raw + digit * cells_.width.raw +
                         (digit >= 2 ? colon_.raw : 0));
}

Rect Clock::cell(int32_t digit) const noexcept {
  return cells_box(cells_, {left_of(digit), origin_.y}, 0, 1);
}

Rect Clock::box() const noexcept {
  return bounding_box(cell(0), cell(kDigits - 1));
}

uint16_t Clock::glyph_of(uint16_t minute, int32_t digit) const noexcept {
  return face_.font->glyph_or_notdef('0' + digit_of(minute, digit));
}

Q16_16 Clock::progress(int32_t digit) const noexcept {
  return digit_of(from_, digit) == digit_of(to_, digit) ? Q16_16::from_int(1)
                                                        : part_at(since_ms_);
}

Rect Clock::at(uint32_t from_minute,
               uint32_t to_minute,
               int32_t since_ms) noexcept {
  const auto from = static_cast<uint16_t>(from_minute % kMinutesPerDay);
  const auto to = static_cast<uint16_t>(to_minute % kMinutesPerDay);
  const bool is_first = from_ == 0xffff;
  Rect changed;
  for (int32_t i = 0; i < kDigits; ++i) {
    // What is shown: two digits and how far the first one is to the second.
    const auto shown = [i](uint32_t a, uint32_t b, int32_t ms) -> uint32_t {
      const uint32_t first = digit_of(a, i);
      const uint32_t second = digit_of(b, i);
      const auto part = static_cast<uint32_t>(part_at(ms).raw);
      return first == second || part == 0 ? first
             : part == 65536              ? second
                                          : part << 8 | first << 4 | second;
    };
    if (is_first || shown(from_, to_, since_ms_) != shown(from, to, since_ms)) {
      changed = bounding_box(changed, cell(i));
    }
  }
  from_ = from;
  to_ = to;
  since_ms_ = since_ms;
  return is_first ? box() : changed;
}

void Clock::draw_digit(const Painter& painter,
                       const Style& style,
                       int32_t digit) const noexcept {
  if (from_ == 0xffff) {
    return;
  }
  const Font& font = *face_.font;
  const Q16_16 part = progress(digit);
  const uint16_t glyphs[2] = {glyph_of(from_, digit), glyph_of(to_, digit)};
  const Face face = {&font, &style};
  OutlineMorph morph;
  if (part.raw == 1 << 16) {
    draw_roll(painter, face, cells_, {left_of(digit), origin_.y},
              {glyphs[1], kBlank}, Q16_16());
  } else if (OutlineMorph::open(font, glyphs[0], glyphs[1], morph) ==
                 Status::ok &&
             OutlineMorph::workspace_bytes(font) <= painter.ram().size) {
    // Glyphs are centred by their advance.
    const int32_t advance_q6 = morph.advance(style, part).raw;
    Sink sink = painter.sink();
    sink.window = intersect(sink.window, cell(digit));
    if (!is_empty(sink.window)) {
      morph.draw(painter.with(sink), style,
                 {Q26_6::from_raw(left_of(digit).raw +
                                  (cells_.width.raw - advance_q6) / 2),
                  origin_.y},
                 part);
    }
  } else {
    draw_roll(painter, face, cells_, {left_of(digit), origin_.y}, glyphs, part);
  }
}

void Clock::draw_colon(const Painter& painter) const noexcept {
  const Font& font = *face_.font;
  // In the middle of the height of digits.
  const uint16_t colon = font.glyph_or_notdef(':');
  GlyphMetrics ink;
  static_cast<void>(font.glyph_metrics(colon, ink));
  TextMeasure measure;
  measure.y_min = ink.y_min;
  measure.y_max = ink.y_max;
  const PixelMeasure px = to_px(font, *face_.style, measure);
  const int32_t lift =
      ((cells_.top + cells_.bottom) * 64 - px.top.raw - px.bottom.raw) / 2;
  painter.for_motion().glyph(font, *face_.style,
                             {Q26_6::from_raw(left_of(2).raw - colon_.raw),
                              Q26_6::from_raw(origin_.y.raw + lift)},
                             colon);
}

void Clock::draw(const Painter& painter) const noexcept {
  draw_colon(painter);
  for (int32_t i = 0; i < kDigits; ++i) {
    draw_digit(painter, *face_.style, i);
  }
}

}  // namespace kinetic
}  // namespace inkcell
