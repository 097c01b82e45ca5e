#include "outlines/point_warp.hpp"

namespace inkcell {
namespace detail {

void AxisWarp::set(const RowMap& rows,
                   int32_t baseline_q8,
                   int32_t samples) noexcept {
  count_ = rows.count;
  for (int32_t i = 0; i < count_; ++i) {
    // The highest knot has the least y.
    const RowMap::Knot& from = rows.knots[count_ - 1 - i];
    Knot& knot = knots_[i];
    knot.from_q8 = baseline_q8 - (from.glyph_q10 * samples >> 2);
    knot.to_q8 = baseline_q8 - (from.screen_q10 * samples >> 2);
    knot.slope_q12 = 1 << 12;
    if (i != 0) {
      Knot& before = knots_[i - 1];
      const int32_t length = knot.from_q8 - before.from_q8;
      if (length > 0) {
        before.slope_q12 = (knot.to_q8 - before.to_q8) * (1 << 12) / length;
      }
    }
  }
}

int32_t AxisWarp::map(int32_t at_q8) const noexcept {
  const Knot* knot = knots_ + count_ - 1;
  while (knot != knots_ && knot->from_q8 > at_q8) {
    --knot;
  }
  const int32_t beyond = at_q8 - knot->from_q8;
  // Between two knots the product is at most 2^30: they lie within 1024 px, and
  // their distances differ by 2 px.
  return knot->to_q8 +
         (beyond > 0 && knot->slope_q12 != 1 << 12
              ? static_cast<int32_t>(int64_t{beyond} * knot->slope_q12 >> 12)
              : beyond);
}

void PointWarp::apply(ScreenPoint* points,
                      const ScreenPoint* end) const noexcept {
  for (; points != end; ++points) {
    if (!x.is_identity()) {
      points->x_q8 = x.map(points->x_q8);
    }
    if (!y.is_identity()) {
      *points =
          ScreenPoint::at(points->x_q8, y.map(points->y_q8()), points->kind());
    }
  }
}

}  // namespace detail
}  // namespace inkcell
