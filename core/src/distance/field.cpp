// Distances and gradients, as programs ask for them.
#include "inkcell/field.hpp"

#include "distance/sampler.hpp"
#include "distance/vertex.hpp"
#include "inkcell/render.hpp"

namespace inkcell {
namespace {

using detail::CellSampler;
using detail::GlyphPoint;

// A place in u, where a px is a u.
GlyphPoint place_of(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  const auto q20 = [](Q16_16 u) noexcept {
    return static_cast<uint32_t>(u.raw) * 16 + detail::kHalfQ20;
  };
  return {static_cast<uint32_t>(x.raw) - detail::corner_q16(field.x0_u),
          static_cast<uint32_t>(y.raw) - detail::corner_q16(field.y0_u), q20(x),
          q20(y)};
}

// Beyond what the cells know: the greater of the band and the distance to the
// box of the ink.
FieldPoint bound_at(const GlyphField& field,
                    Q16_16 x,
                    Q16_16 y,
                    bool is_inside) noexcept {
  // 1024 u and more are the same. [Q5 u]
  constexpr int32_t kMost = 1 << 15;
  const auto way_q5 = [](int32_t at_q16, int32_t low_u, int32_t high_u) {
    const int32_t at = at_q16 >> 11;
    const int32_t way = at < low_u * 32    ? low_u * 32 - at
                        : at > high_u * 32 ? high_u * 32 - at
                                           : 0;
    return detail::min(detail::max(way, -kMost), kMost);
  };
  FieldPoint point;
  point.is_bound = true;
  int32_t distance_q5 = field.band_u * 32;
  if (!is_inside) {
    const int32_t right = way_q5(x.raw, field.ink.x0_u, field.ink.x1_u);
    const int32_t up = way_q5(y.raw, field.ink.y0_u, field.ink.y1_u);
    // 2^30 each, and twice that together.
    const auto away = static_cast<int32_t>(detail::root(
        static_cast<uint32_t>(right * right) + static_cast<uint32_t>(up * up)));
    if (away > 0) {
      point.gradient.x.raw = static_cast<int16_t>(right * (1 << 14) / away);
      point.gradient.y.raw = static_cast<int16_t>(up * (1 << 14) / away);
    }
    distance_q5 = detail::max(distance_q5, away);
  }
  distance_q5 = detail::min(distance_q5, kMost);
  point.distance.raw = (is_inside ? distance_q5 : -distance_q5) * 32;
  return point;
}

}  // namespace

Q22_10 distance_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  CellSampler sampler(field);
  return Q22_10::from_raw(sampler.distance_q10(place_of(field, x, y)));
}

Gradient gradient_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  CellSampler sampler(field);
  return sampler.glyph_gradient(place_of(field, x, y));
}

FieldPoint point_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  CellSampler sampler(field);
  const FieldPoint point = sampler.glyph_point(place_of(field, x, y));
  if (sampler.is_saturated()) {
    return bound_at(field, x, y, sampler.is_saturated_inside());
  }
  const bool is_far = field.band_u != 0 &&
                      detail::abs(point.distance.raw) > field.band_u * 1024;
  return is_far ? bound_at(field, x, y, point.distance.raw > 0) : point;
}

void distance_row(const GlyphField& field,
                  const TextStyle& style,
                  FinePoint origin,
                  int32_t x,
                  int32_t y,
                  Span<Q6_10> out) noexcept {
  CellSampler sampler(field, style, detail::kNoReach);
  for (Q6_10& distance : out) {
    GlyphPoint at;
    const bool is_near = sampler.find(origin, x, y, {0, 0}, at);
    int32_t in_px = is_near ? sampler.distance_q10(at) : INT16_MIN;
    in_px = detail::min(detail::max(in_px, INT16_MIN), INT16_MAX);
    distance.raw = static_cast<int16_t>(in_px);
    ++x;
  }
}

}  // namespace inkcell
