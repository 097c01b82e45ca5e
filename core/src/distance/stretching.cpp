// A primitive f of a glyph, as the screen shows it, has the gradient A f',
// where the rows of A are the style's steps. An edge at the distance f in the
// glyph is at f |f'| / |A f'| on the screen, to first order: exactly where f is
// a plane. The quotient, the gain, depends on the gradient's direction alone,
// so that bends keep their effect. Each primitive becomes a plane of the screen
// before vertices are rounded: a corner's distance is then a true one as well.
#include "distance/stretching.hpp"

#include "distance/samples.hpp"

namespace inkcell {
namespace detail {
namespace {

uint32_t size_of(int32_t value) noexcept {
  return static_cast<uint32_t>(abs(value));
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
  uint32_t size = size_of(v.x) | size_of(v.y);
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
  return size_of(v.x) <= 1u << 15 && size_of(v.y) <= 1u << 15 &&
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

int32_t far_of(const TextStyle& style, int32_t reach_q22) noexcept {
  // Gains are rounded, and so is the quotient: it must not be too small.
  const auto gain = static_cast<uint32_t>(style.least_gain_q15() - 2);
  const uint32_t reach_q15 = static_cast<uint32_t>(reach_q22) >> 7;
  if (reach_q15 >= gain << 8) {
    return kMaxFarQ22;
  }
  return static_cast<int32_t>(((reach_q15 << 8) / gain + 1) << 14);
}

Vector on_screen(const Csg& csg, Vector gradient) noexcept {
  if (is_unit(gradient)) {
    return gain_of(csg.style(), gradient).unit_q14;
  }
  const Vector unit_q14 = direct(gradient).unit_q14;
  return scaled(gain_of(csg.style(), unit_q14).unit_q14,
                product_q14(gradient, unit_q14));
}

int32_t stretched_value(const Csg& csg,
                        PlacedLeaf& leaf,
                        const PixelPlace& at) noexcept {
  const int32_t far_q22 = csg.far_q22();
  const int32_t sign = leaf.sign;
  int32_t values[3] = {};
  // What decides without stretching: a primitive that is far outside, or all
  // that are far inside.
  int32_t least_q22 = INT32_MAX;
  for (uint32_t i = 0; i < leaf.count; ++i) {
    const ArcValue primitive(leaf.parts[i], csg.scale(), 0);
    const int32_t value_q22 = primitive.at(at, csg.bend_shift(), sign);
    if (value_q22 <= -far_q22 && (i == 0 || !leaf.is_nested)) {
      return with_sign(value_q22, sign);
    }
    least_q22 = min(least_q22, value_q22);
    values[i] = value_q22;
  }
  if (least_q22 >= far_q22) {
    return with_sign(least_q22, sign);
  }
  for (uint32_t i = 0; i < leaf.count; ++i) {
    int32_t& value_q22 = values[i];
    if (value_q22 >= far_q22 || value_q22 <= -far_q22) {
      value_q22 = value_q22 < 0 ? -kMaxFarQ22 : kMaxFarQ22;
      continue;
    }
    const ArcValue primitive(leaf.parts[i], csg.scale(), 0);
    const Vector gradient = primitive.gradient_q14(at, csg.bend_shift());
    const Gain gain = gain_of(
        csg.style(), is_unit(gradient) ? gradient : direct(gradient).unit_q14);
    value_q22 = with_sign(gain.of(with_sign(value_q22, sign)), sign);
  }
  const int32_t value_q22 = csg.combine(leaf, values, at);
  return min(max(value_q22, -far_q22), far_q22);
}

int32_t stretched_samples(const Csg& csg,
                          const Leaf& leaf,
                          uint32_t x_q16,
                          uint32_t y_q16) noexcept {
  const uint8_t* const samples = leaf.parts[0];
  const int32_t distance_q10 = csg.style().to_px_q10(
      samples_distance_q10(samples, leaf.size_log2, x_q16, y_q16));
  const Gradient gradient =
      samples_gradient(samples, leaf.size_log2, x_q16, y_q16);
  const Vector unit_q14 = direct({gradient.x.raw, gradient.y.raw}).unit_q14;
  const int32_t screen_q10 = gain_of(csg.style(), unit_q14).of(distance_q10);
  constexpr int32_t kMost = kMaxFarQ22 >> 12;
  return min(max(screen_q10, -kMost), kMost) * (1 << 12);
}

}  // namespace

const Stretching kStretching = {far_of, stretched_value, stretched_samples,
                                on_screen};

}  // namespace detail
}  // namespace inkcell
