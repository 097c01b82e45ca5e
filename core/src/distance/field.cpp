// Distances and gradients, as programs ask for them.
#include "inkcell/field.hpp"

#include "distance/sampler.hpp"
#include "inkcell/render.hpp"

namespace inkcell {
namespace {

using detail::CellSampler;
using detail::GlyphPoint;

// A place in u, where a px is a u.
GlyphPoint point_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  const auto q20 = [](Q16_16 u) noexcept {
    return static_cast<uint32_t>(u.raw) * 16 + detail::kHalfQ20;
  };
  return {static_cast<uint32_t>(x.raw) - detail::corner_q16(field.x0_u),
          static_cast<uint32_t>(y.raw) - detail::corner_q16(field.y0_u), q20(x),
          q20(y)};
}

}  // namespace

Q22_10 distance_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  CellSampler sampler(field);
  return Q22_10::from_raw(sampler.distance_q10(point_at(field, x, y)));
}

Gradient gradient_at(const GlyphField& field, Q16_16 x, Q16_16 y) noexcept {
  CellSampler sampler(field);
  return sampler.glyph_gradient(point_at(field, x, y));
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
