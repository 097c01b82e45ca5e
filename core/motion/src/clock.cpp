// All digits of a change move together: between both times no third one shows.
#include "inkcell/motion/clock.hpp"

#include "inkcell/motion/easing.hpp"
#include "inkcell/motion/outline_morph.hpp"
#include "inkcell/motion/timeline.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

constexpr Easing kChange = cubic_bezier(650, 0, 350, 1000);

uint32_t digit_of(uint32_t second, int32_t digit) noexcept {
  constexpr struct {
    uint16_t seconds;
    uint16_t values;
  } kPlaces[] = {{36000, 10}, {3600, 10}, {600, 6}, {60, 10}, {10, 6}, {1, 10}};
  return second / kPlaces[digit].seconds % kPlaces[digit].values;
}

bool find_way(const Font& font,
              uint32_t from,
              uint32_t to,
              OutlineMorph& morph) noexcept {
  return OutlineMorph::open(font, font.glyph_or_notdef('0' + from),
                            font.glyph_or_notdef('0' + to),
                            morph) == Status::ok;
}

// Whether all digits of a change have a way. Not inline: a frame of its own.
__attribute__((noinline)) bool have_ways(const Font& font,
                                         uint32_t from,
                                         uint32_t to,
                                         int32_t digits) noexcept {
  for (int32_t i = 0; i < digits; ++i) {
    OutlineMorph morph;
    if (!find_way(font, digit_of(from, i), digit_of(to, i), morph)) {
      return false;
    }
  }
  return true;
}

Q16_16 part_at(int32_t since_ms) noexcept {
  return ease(kChange, fraction(0, Clock::kEndMs, since_ms));
}

}  // namespace

Clock::Clock(const Font& font,
             const Style& style,
             Point origin,
             ClockUnit unit) noexcept
    : face_{&font, &style},
      origin_(origin),
      cells_(measure_digits(font, style)),
      colon_(to_px(font, style, font.advance(font.glyph_or_notdef(':')))),
      unit_(unit) {}

Q26_6 Clock::left_of(int32_t digit) const noexcept {
  return Q26_6::from_raw(origin_.x.raw + digit * cells_.width.raw +
                         digit / 2 * colon_.raw);
}

Rect Clock::cell(int32_t digit) const noexcept {
  return cells_box(cells_, {left_of(digit), origin_.y}, 0, 1);
}

Rect Clock::box() const noexcept {
  return bounding_box(cell(0), cell(digits() - 1));
}

Q16_16 Clock::progress(int32_t digit) const noexcept {
  return digit_of(from_, digit) == digit_of(to_, digit) ? Q16_16::from_int(1)
                                                        : part_at(since_ms_);
}

Rect Clock::at(uint32_t from, uint32_t to, int32_t since_ms) noexcept {
  const uint32_t unit = unit_ == ClockUnit::seconds ? 1 : 60;
  constexpr uint32_t kDay = 24 * 60 * 60;
  from = from % (kDay / unit) * unit;
  to = to % (kDay / unit) * unit;
  const bool is_first = from_ == UINT32_MAX;
  Rect changed;
  for (int32_t i = 0; i < digits(); ++i) {
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
  if (from_ != from || to_ != to) {
    can_morph_ = have_ways(*face_.font, from, to, digits());
  }
  from_ = from;
  to_ = to;
  since_ms_ = since_ms;
  return is_first ? box() : changed;
}

void Clock::draw_digit(const Painter& painter,
                       const Style& style,
                       int32_t digit) const noexcept {
  if (from_ == UINT32_MAX) {
    return;
  }
  const Font& font = *face_.font;
  const Q16_16 part = progress(digit);
  const uint32_t values[2] = {digit_of(from_, digit), digit_of(to_, digit)};
  Point at = {left_of(digit), origin_.y};
  OutlineMorph morph;
  if (part.raw == 1 << 16 || !can_morph_ ||
      !find_way(font, values[0], values[1], morph) ||
      OutlineMorph::workspace_bytes(font) > painter.ram().size) {
    const uint16_t glyphs[2] = {font.glyph_or_notdef('0' + values[0]),
                                font.glyph_or_notdef('0' + values[1])};
    draw_roll(painter, {&font, &style}, cells_, at, glyphs, part);
    return;
  }
  Sink sink = painter.sink();
  sink.window = intersect(sink.window, cell(digit));
  if (!is_empty(sink.window)) {
    // Glyphs are centred by their advance.
    at.x.raw += (cells_.width.raw - morph.advance(style, part).raw) / 2;
    morph.draw(painter.with(sink), style, at, part);
  }
}

void Clock::draw_colons(const Painter& painter) const noexcept {
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
  const Painter moving = painter.for_motion();
  for (int32_t i = 2; i < digits(); i += 2) {
    moving.glyph(font, *face_.style,
                 {Q26_6::from_raw(left_of(i).raw - colon_.raw),
                  Q26_6::from_raw(origin_.y.raw + lift)},
                 colon);
  }
}

void Clock::draw(const Painter& painter) const noexcept {
  draw_colons(painter);
  for (int32_t i = 0; i < digits(); ++i) {
    draw_digit(painter, *face_.style, i);
  }
}

}  // namespace inkcell::motion
