#include "field_code.hpp"

#include <algorithm>
#include <cmath>

namespace inkcell {
namespace gen {
namespace {
constexpr double kPi = 3.14159265358979323846;
}

Quantisation Quantisation::make(double e0_u, double band_u) {
  Quantisation q;
  q.d0_step_q6 =
      std::clamp(static_cast<int>(std::lround(64 * 0.5 * e0_u)), 1, 255);
  q.bend_step_q6 =
      std::clamp(static_cast<int>(std::lround(64 * 0.75 * e0_u)), 1, 255);
  q.d0_log2 = std::clamp(static_cast<int>(std::ceil(std::log2(band_u))), 4, 8);
  q.d0_base = static_cast<int>(
      std::ceil(std::log2(2 * std::ldexp(64.0, q.d0_log2) / q.d0_step_q6)));
  q.angle_base = std::clamp(
      static_cast<int>(std::lround(std::log2(2 * kPi * 24 / (0.5 * e0_u)))), 4,
      10);
  return q;
}

DirectField expand(const FieldCode& code,
                   const Quantisation& q,
                   int size_log2,
                   int x_u,
                   int y_u) {
  const bool axis =
      code.kind == FieldKind::axis || code.kind == FieldKind::axis_arc;
  const double turn = axis ? code.angle / 4.0
                           : std::ldexp(code.angle, -q.angle_bits(size_log2));
  DirectField f;
  f.nx = static_cast<int16_t>(std::lround(16384 * std::cos(2 * kPi * turn)));
  f.ny = static_cast<int16_t>(std::lround(16384 * std::sin(2 * kPi * turn)));
  const int dot = f.nx * x_u + f.ny * y_u;    // Q14
  const int cross = f.nx * y_u - f.ny * x_u;  // Q14
  f.c = static_cast<int16_t>((code.d0 * q.d0_step_q6 * 256 - dot + 512) >> 10);
  if (code.kind == FieldKind::arc || code.kind == FieldKind::axis_arc) {
    f.cw = static_cast<int16_t>((-cross + 512) >> 10);
    // k/2 v^2 = bend * step at v = 2^log2 u, in 2^-19 / u.
    const int shift = 13 - 2 * bend_length_log2(size_log2);
    const int bend = code.bend * q.bend_step_q6;
    int k = shift >= 0 ? bend * (1 << shift)
                       : (bend + (1 << (-shift - 1))) >> -shift;
    f.k = static_cast<int16_t>(std::clamp(k, -32767, 32767));
  }
  return f;
}

}  // namespace gen
}  // namespace inkcell
