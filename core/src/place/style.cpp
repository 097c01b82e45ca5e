// Sizes, directions and matrices as the numbers that drawing needs.
#include "inkcell/style.hpp"

#include "base/math.hpp"
#include "inkcell/font.hpp"

namespace inkcell {
namespace {

using detail::magnitude;

// The length of a vector, rounded down; components below 2^30.
int64_t length_of(int64_t x, int64_t y) noexcept {
  return detail::root_of(static_cast<uint64_t>(x * x + y * y));
}

// An entry of a matrix over the size. [px, Q16 -> Q30]
Fixed<int32_t, 30> over_size(Q16_16 entry_px, int32_t size_q6) noexcept {
  return Fixed<int32_t, 30>::from_raw(
      static_cast<int32_t>(int64_t{entry_px.raw} * (1 << 20) / size_q6));
}

// What a row of a matrix's inverse is as a step: entries over the determinant,
// at most 256.
GlyphStep step_from(int32_t x_q30,
                    int32_t y_q30,
                    int64_t determinant_q42,
                    int32_t size_q6) noexcept {
  constexpr int64_t kScale = int64_t{1} << 32;
  const int64_t x_q20 = x_q30 * kScale / determinant_q42;
  const int64_t y_q20 = y_q30 * kScale / determinant_q42;
  // 1024 u over size/64 px: 2^10 2^6 2^-4 / size.
  return {static_cast<int32_t>(x_q20 * (1 << 12) / size_q6),
          static_cast<int32_t>(y_q20 * (1 << 12) / size_q6),
          static_cast<int32_t>(x_q20), static_cast<int32_t>(y_q20)};
}

// A matrix is the sum of a turn and a mirrored turn, each times a number; its
// greatest and least stretch are sum and difference of the two.
struct Gains {
  int64_t turn_q17 = 0;
  int64_t mirror_q17 = 0;
  int shift = 0;  // both numbers times 2^shift; 0 within twice the largest size

  explicit Gains(const Matrix& m) noexcept {
    const uint32_t bits = magnitude(m.x_right.raw) | magnitude(m.x_up.raw) |
                          magnitude(m.y_right.raw) | magnitude(m.y_up.raw);
    while (bits >> shift > uint32_t{kMaxSize.raw} << 11) {
      ++shift;
    }
    const int64_t x_right = m.x_right.raw >> shift;
    const int64_t x_up = m.x_up.raw >> shift;
    const int64_t y_right = m.y_right.raw >> shift;
    const int64_t y_up = m.y_up.raw >> shift;
    turn_q17 = length_of(x_right + y_up, x_up - y_right);
    mirror_q17 = length_of(x_right - y_up, x_up + y_right);
  }
  int64_t least_q17() const noexcept {
    return turn_q17 < mirror_q17 ? mirror_q17 - turn_q17
                                 : turn_q17 - mirror_q17;
  }
  Stretch stretch() const noexcept {
    return {to_q6(least_q17()), to_q6(turn_q17 + mirror_q17)};
  }

 private:
  Q26_6 to_q6(int64_t value_q17) const noexcept {  // at most 2^17 px
    return Q26_6::from_raw(static_cast<int32_t>((value_q17 + (1 << 10)) >> 11)
                           << shift);
  }
};

// Each entry times `to` over `from`.
Matrix scaled(const Matrix& m, Q26_6 to, Q26_6 from) noexcept {
  const auto entry = [&](Q16_16 old) noexcept {
    return Q16_16::from_raw(
        static_cast<int32_t>(int64_t{old.raw} * to.raw / from.raw));
  };
  return {entry(m.x_right), entry(m.x_up), entry(m.y_right), entry(m.y_up)};
}

// Scales a matrix so that its stretches are in range, which they are not.
// False: it is too flat for that.
bool bring_into_range(Matrix& matrix, const Stretch& given) noexcept {
  // To the largest size, where roundings are the smallest. The second time for
  // the roundings of the first.
  Stretch stretch = given;
  for (int i = 0; i < 2; ++i) {
    if (stretch.greatest.raw == 0) {
      return false;
    }
    matrix = scaled(matrix, kMaxSize, stretch.greatest);
    stretch = stretch_of(matrix);
  }
  if (stretch.least.raw < kMinSize.raw) {
    return false;
  }
  if (given.greatest.raw <= kMaxSize.raw) {
    matrix = scaled(matrix, kMinSize, stretch.least);
  }
  return true;
}

// The square of a length. [Q30 -> Q28]
uint32_t squared_q28(Direction direction) noexcept {
  const int64_t cosine = direction.cosine.raw >> 1;
  const int64_t sine = direction.sine.raw >> 1;
  return static_cast<uint32_t>((cosine * cosine + sine * sine) >> 30);
}

// To a unit vector, if it is none within 1/1000. False: it has no direction.
bool bring_to_unit(Direction& direction) noexcept {
  constexpr uint32_t kOneQ28 = 1 << 28;
  constexpr uint32_t kTolerance = kOneQ28 / 500;
  if (squared_q28(direction) - (kOneQ28 - kTolerance) <= 2 * kTolerance) {
    return true;
  }
  int32_t& cosine = direction.cosine.raw;
  int32_t& sine = direction.sine.raw;
  uint32_t bits = magnitude(cosine) | magnitude(sine);
  if (bits == 0) {
    return false;
  }
  // The length to [1/2, sqrt 2], from where Newton's steps converge.
  if (bits >= 1u << 30) {
    cosine /= 2;
    sine /= 2;
  }
  for (; bits < 1u << 29; bits *= 2) {
    cosine *= 2;
    sine *= 2;
  }
  for (int i = 0; i < 8; ++i) {
    // Half of 3 less the square, at most 1.4. [Q30]
    const uint32_t factor_q30 = (3 * kOneQ28 - squared_q28(direction)) * 2;
    cosine = static_cast<int32_t>((int64_t{cosine} * factor_q30) >> 30);
    sine = static_cast<int32_t>((int64_t{sine} * factor_q30) >> 30);
  }
  return true;
}

// The size at which the highest of some characters is `height` px high.
Q26_6 size_for(const Font& font,
               uint32_t first,
               uint32_t last,
               Q26_6 height) noexcept {
  int32_t top = 0;
  for (; first <= last; ++first) {
    uint16_t glyph = 0;
    GlyphMetrics ink;
    if (font.glyph_of(first, glyph) == Status::ok &&
        font.glyph_metrics(glyph, ink) == Status::ok) {
      top = detail::max(top, ink.y_max);
    }
  }
  top = top > 0 ? top : font.metrics().cap_height;
  const int32_t em = font.units_per_em();  // at most 2^14
  const int32_t high_q6 = detail::clamp(height.raw, 0, kMaxSize.raw);
  // Rounded down, so that no ink is in another row.
  return Q26_6::from_raw(detail::quotient(high_q6 * em, top > 0 ? top : em));
}

}  // namespace

Stretch stretch_of(const Matrix& matrix) noexcept {
  return Gains(matrix).stretch();
}

Style Style::for_cap_height(const Font& font,
                            Q26_6 height,
                            const Filter& filter) noexcept {
  return Style(size_for(font, 'H', 'H', height), filter);
}

Style Style::for_digit_height(const Font& font,
                              Q26_6 height,
                              const Filter& filter) noexcept {
  return Style(size_for(font, '0', '9', height), filter);
}

Style::Style(Q26_6 size, const Filter& filter, Direction direction) noexcept
    : Style(size, filter) {
  if (!bring_to_unit(direction)) {
    return;
  }
  const int64_t cosine = direction.cosine.raw;
  const int64_t sine = direction.sine.raw;
  if (sine == 0 && cosine > 0) {
    return;  // upright
  }
  const int64_t step_q16 = right_.x_q16;
  const auto along = static_cast<int32_t>((step_q16 * cosine) >> 30);
  const auto across = static_cast<int32_t>((step_q16 * sine) >> 30);
  const int32_t along_px = direction.cosine.raw >> 10;
  const int32_t across_px = direction.sine.raw >> 10;
  right_ = {along, -across, along_px, -across_px};
  up_ = {across, along, across_px, along_px};
  axes_ = {direction.cosine, direction.sine,
           Fixed<int32_t, 30>::from_raw(-direction.sine.raw), direction.cosine};
  set_slanted();
}

Style::Style(const Matrix& given, const Filter& filter) noexcept
    : Style(kMinSize, filter) {
  Matrix matrix = given;
  Gains gains(matrix);
  const Stretch stretch = gains.stretch();
  bool is_flat = false;
  if (!stretch.is_in_range()) {
    is_flat = !bring_into_range(matrix, stretch);
    gains = Gains(is_flat ? given : matrix);
  }
  *this = Style(gains.stretch().greatest, filter);
  const int32_t size_q6 = size_q6_;
  const bool is_plain = gains.mirror_q17 == 0 && matrix.x_up.raw == 0 &&
                        matrix.x_right.raw == int64_t{size_q6} << 10;
  if (is_flat || is_plain) {
    return;  // upright
  }
  axes_ = {over_size(matrix.x_right, size_q6), over_size(matrix.x_up, size_q6),
           over_size(matrix.y_right, size_q6), over_size(matrix.y_up, size_q6)};
  const int64_t determinant_q60 = int64_t{axes_.x_right.raw} * axes_.y_up.raw -
                                  int64_t{axes_.x_up.raw} * axes_.y_right.raw;
  // At least 1/256, in Q42.
  const int64_t determinant_q42 = determinant_q60 / (1 << 18);
  right_ = step_from(axes_.y_up.raw, -axes_.x_up.raw, determinant_q42, size_q6);
  up_ = step_from(-axes_.y_right.raw, axes_.x_right.raw, determinant_q42,
                  size_q6);
  set_slanted();
  // What stretches all edges within 1/1000 alike is as good as a turn.
  const int64_t turn_q17 = gains.turn_q17;
  const int64_t mirror_q17 = gains.mirror_q17;
  const int64_t lesser = turn_q17 < mirror_q17 ? turn_q17 : mirror_q17;
  constexpr int64_t kOneQ15 = 1 << 15;
  if (lesser * 2048 > turn_q17 + mirror_q17) {
    // Below one, so that the style is known as stretched.
    const int64_t gain_q15 = (gains.least_q17() << 4) / size_q6;
    least_gain_q15_ =
        static_cast<uint16_t>(gain_q15 < kOneQ15 ? gain_q15 : kOneQ15 - 1);
  }
}

bool is_same(const Style& a, const Style& b) noexcept {
  return a.size_q6_ == b.size_q6_ && a.axes_.x_right == b.axes_.x_right &&
         a.axes_.x_up == b.axes_.x_up && a.axes_.y_right == b.axes_.y_right &&
         a.axes_.y_up == b.axes_.y_up && a.filter_ == b.filter_ &&
         a.fitter() == b.fitter() && a.fit_options_ == b.fit_options_ &&
         a.effect_ == b.effect_;
}

}  // namespace inkcell
