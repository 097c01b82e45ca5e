// Distances on the screen where a style stretches edges differently.
//
// A field f of a glyph, as the screen shows it, has the gradient A f', where
// the rows of A are the style's steps. An edge at the distance f in the glyph
// is at f |f'| / |A f'| on the screen, to first order: exactly where the field
// is a plane. The quotient, the gain, depends on the gradient's direction
// alone, so that a field keeps what its bends stand for if nothing is
// stretched. Each field becomes a plane of the screen before vertices are
// rounded: a corner's distance is then a true one as well.
#include "cells/cell_access.hpp"
#include "raster/field_turned.hpp"

namespace inkcell {
namespace detail {
namespace {

// Farther than this, 256 px, is far everywhere.
constexpr int32_t kMaxFarQ22 = 1 << 30;

uint32_t abs(int32_t value) noexcept {
  const auto plain = static_cast<uint32_t>(value);
  return value < 0 ? 0u - plain : plain;
}

// A vector's direction, and 1 / length = inverse_q14 2^-exponent 2^-14.
struct Direct {
  Vector unit_q14;
  uint32_t inverse_q14;  // 1..2
  int32_t exponent;
};

// 1 / sqrt(x) of x in 1/4..1 from 12 guesses and two steps of Newton's method,
// to 2^-14. [Q32 -> Q14]
uint32_t inverse_root_q14(uint32_t x_q32) noexcept {
  static constexpr uint8_t kGuessesQ7[] = {241, 218, 201, 187, 176, 166,
                                           158, 151, 145, 139, 134, 130};
  const uint32_t x_q14 = x_q32 >> 18;
  uint32_t y_q14 = static_cast<uint32_t>(kGuessesQ7[(x_q32 >> 28) - 4]) << 7;
  for (int i = 0; i < 2; ++i) {
    const uint32_t square_q16 = (y_q14 * y_q14) >> 12;
    const uint32_t factor_q14 = (3u * (1u << 30) - x_q14 * square_q16) >> 16;
    y_q14 = (y_q14 * factor_q14) >> 15;
  }
  return y_q14;
}

// Any vector but 0, which gets some direction.
Direct direct(Vector v) noexcept {
  uint32_t size = abs(v.x) | abs(v.y);
  if (size == 0) {
    v.x = 1;
    size = 1;
  }
  // The greater one to 15 bits.
  const int32_t exponent = 17 - __builtin_clz(size);
  if (exponent >= 0) {
    v.x >>= exponent;
    v.y >>= exponent;
  } else {
    v.x *= 1 << -exponent;
    v.y *= 1 << -exponent;
  }
  // 2^28 to 2^31.
  uint32_t square = times(v.x, static_cast<uint32_t>(v.x)) +
                    times(v.y, static_cast<uint32_t>(v.y));
  int32_t doublings = 0;
  while (square < 1u << 30) {
    square <<= 2;
    ++doublings;
  }
  Direct result;
  result.inverse_q14 = inverse_root_q14(square);
  const auto inverse = static_cast<int32_t>(result.inverse_q14);
  const int32_t shift = 16 - doublings;
  result.unit_q14 = {(v.x * inverse) >> shift, (v.y * inverse) >> shift};
  result.exponent = exponent + shift;
  return result;
}

// Within 1/2000, as normals of lines are.
bool is_unit(const Vector& v) noexcept {
  const uint32_t square = times(v.x, static_cast<uint32_t>(v.x)) +
                          times(v.y, static_cast<uint32_t>(v.y));
  return abs(v.x) <= 1u << 15 && abs(v.y) <= 1u << 15 &&
         square - ((1u << 28) - (1u << 18)) < 1u << 19;
}

// The length of a gradient from its direction, less than 2.
int32_t product_q14(const Vector& gradient, const Vector& unit_q14) noexcept {
  const int32_t length_q14 =
      wrapped(times(gradient.x, static_cast<uint32_t>(unit_q14.x)) +
              times(gradient.y, static_cast<uint32_t>(unit_q14.y))) >>
      14;
  return length_q14 < INT16_MAX ? length_q14 : INT16_MAX;
}

Vector scaled(const Vector& unit_q14, int32_t length_q14) noexcept {
  return {(unit_q14.x * length_q14) >> 14, (unit_q14.y * length_q14) >> 14};
}

// A distance in the glyph as one on the screen, and the direction there.
struct Gain {
  uint32_t inverse_q14;
  int32_t shift;  // the gain is inverse_q14 / 2^(14 + shift)
  Vector unit_q14;

  // `value_q22` below 2^30.
  int32_t of(int32_t value_q22) const noexcept {
    const auto inverse = static_cast<int32_t>(inverse_q14);
    const int32_t half_q22 =
        (value_q22 >> 15) * inverse + (((value_q22 & 0x7fff) * inverse) >> 15);
    return shift < 0 ? half_q22 * 2 : half_q22 >> shift;
  }
};

Gain gain_of(const TextStyle& style, const Vector& unit_q14) noexcept {
  // Steps are at most one over the least gain.
  int32_t log2 = 5;
  for (int32_t gain = style.least_gain_q15(); gain < 1 << 14; gain *= 2) {
    ++log2;
  }
  const auto along = [&](const GlyphStep& step) noexcept {
    return unit_q14.x * (step.x_q20 >> log2) +
           unit_q14.y * (step.y_q20 >> log2);
  };
  const Direct screen = direct({along(style.right()), along(style.up())});
  // Of a length in Q(34 - log2); 15 of them are taken off when it is used.
  return {screen.inverse_q14, screen.exponent + log2 - 35, screen.unit_q14};
}

}  // namespace

int32_t far_q22(const TextStyle& style, int32_t reach_q22) noexcept {
  // Gains are rounded, and so is the quotient: it must not be too small.
  const auto gain = static_cast<uint32_t>(style.least_gain_q15() - 2);
  const uint32_t reach_q15 = static_cast<uint32_t>(reach_q22) >> 7;
  if (reach_q15 >= gain << 8) {
    return kMaxFarQ22;
  }
  return static_cast<int32_t>(((reach_q15 << 8) / gain + 1) << 14);
}

void stretch_terms(const TextStyle& style,
                   int32_t far_q22,
                   FieldTerms& terms) noexcept {
  const int32_t bend_shift = style.bend_shift();
  for (uint32_t i = 0; i < terms.count; ++i) {
    FieldTerm& term = terms.term[i];
    const int32_t value_q22 = term.value_q22(bend_shift);
    const bool is_far = value_q22 >= far_q22 || value_q22 <= -far_q22;
    Gain gain = {};
    Vector normal_q14 = {0, 0};
    if (!is_far) {
      const Vector gradient = gradient_q14(term, bend_shift);
      if (is_unit(gradient)) {
        gain = gain_of(style, gradient);
        normal_q14 = gain.unit_q14;
      } else {
        const Vector unit_q14 = direct(gradient).unit_q14;
        gain = gain_of(style, unit_q14);
        normal_q14 = scaled(gain.unit_q14, product_q14(gradient, unit_q14));
      }
    }
    const int32_t sign = value_q22 < 0 ? -1 : 1;
    term = {
        static_cast<uint32_t>(is_far ? sign * kMaxFarQ22 : gain.of(value_q22)),
        0, 0, static_cast<int16_t>(normal_q14.x),
        static_cast<int16_t>(normal_q14.y)};
  }
}

int32_t stretched_fields_q10(const GlyphField& field,
                             const TextStyle& style,
                             const FieldPosition& at,
                             int32_t reach_q22) noexcept {
  const int32_t x_u = at.x_q16 >> 16;
  const int32_t y_u = at.y_q16 >> 16;
  Cell cell;
  if (in_grid(field, x_u, y_u)) {
    cell = locate_fields(field, x_u, y_u);
  }
  if (cell.field_count == 0) {
    return (cell.inside ? kMaxFarQ22 : -kMaxFarQ22) >> 12;
  }
  FieldTerms terms;
  set_up_terms(terms, field, cell, q8_of(at.x_q20), q8_of(at.y_q20),
               scale_of(style));
  stretch_terms(style, far_q22(style, reach_q22), terms);
  return combine_q22(terms, style.bend_shift(), reach_q22) >> 12;
}

int32_t stretched_samples_q10(const GlyphField& field,
                              const TextStyle& style,
                              const FieldPosition& at) noexcept {
  const int32_t distance_q10 =
      style.to_px_q10(samples_distance_q10(field, at.x_q16, at.y_q16));
  const Gradient gradient = gradient_at(field, Q16_16::from_raw(at.x_q16),
                                        Q16_16::from_raw(at.y_q16));
  const Vector unit_q14 = direct({gradient.x.raw, gradient.y.raw}).unit_q14;
  return gain_of(style, unit_q14).of(distance_q10);
}

}  // namespace detail
}  // namespace inkcell
