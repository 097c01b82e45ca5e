// Wheels of digits.
#include "inkcell/motion/counter.hpp"

#include "limits.hpp"

namespace inkcell::motion {
namespace {

constexpr int32_t kMostDigits = 9;
constexpr uint32_t kPowers[kMostDigits + 1] = {
    1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000, 1000000000};

}  // namespace

struct Counter::Wheel {
  uint16_t digits[2];  // glyphs; kBlank: a leading zero
  Q16_16 part;
};

Counter::Counter(const Font& font,
                 const Style& style,
                 Point origin,
                 int32_t digits) noexcept
    : face_{&font, &style},
      origin_(origin),
      cells_(measure_digits(font, style)),
      digits_(clamp(digits, 1, kMostDigits)) {}

void Counter::roll(int32_t from,
                   int32_t to,
                   const Timing& timing,
                   const Easing& easing) noexcept {
  from_ = from;
  to_ = to;
  timing_ = timing;
  easing_ = easing;
}

Counter::Wheel Counter::wheel(int64_t value_q16, int32_t place) const noexcept {
  const uint32_t power = kPowers[place];
  const auto whole = static_cast<uint32_t>(value_q16 >> 16);
  Wheel wheel;
  for (uint32_t i = 0; i < 2; ++i) {
    const uint32_t value = whole + i;
    wheel.digits[i] =
        value < power && place != 0
            ? kBlank
            : face_.font->glyph_or_notdef('0' + value / power % 10);
  }
  // It turns while all wheels to its right go from 9 to 0.
  wheel.part.raw =
      whole % power == power - 1 ? static_cast<int32_t>(value_q16 & 0xffff) : 0;
  return wheel;
}

// Of the last `wheels`.
Rect Counter::box_of(int32_t wheels) const noexcept {
  return cells_box(cells_, origin_, digits_ - wheels, digits_);
}

Rect Counter::at(int32_t now_ms) noexcept {
  const Q16_16 part = ease(easing_, progress_at(timing_, now_ms));
  const int64_t most = (int64_t{kPowers[digits_]} - 1) << 16;
  const int64_t exact =
      int64_t{from_} * 65536 + (int64_t{to_} - int64_t{from_}) * part.raw;
  const int64_t value = exact < 0 ? 0 : exact > most ? most : exact;
  const int64_t last = value_q16_;
  value_q16_ = value;
  if (last < 0) {
    return box();
  }
  // Wheels to the left of one that stands still do not turn either.
  int32_t changed = digits_;
  for (; changed > 0; --changed) {
    const Wheel a = wheel(last, changed - 1);
    const Wheel b = wheel(value, changed - 1);
    if (a.part.raw != b.part.raw || a.digits[0] != b.digits[0]) {
      return box_of(changed);
    }
  }
  return {};
}

void Counter::draw(const Painter& painter) const noexcept {
  for (int32_t place = 0; place < digits_ && value_q16_ >= 0; ++place) {
    const Wheel now = wheel(value_q16_, place);
    Point at = origin_;
    at.x.raw += (digits_ - 1 - place) * cells_.width.raw;
    draw_roll(painter, face_, cells_, at, now.digits, now.part);
  }
}

}  // namespace inkcell::motion
