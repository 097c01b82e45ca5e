#include "rows/point_warp.hpp"

namespace inkcell {
namespace detail {
namespace {

// A map for points that follow each other, from an origin in samples.
class AxisWarp {
 public:
  AxisWarp(const AxisMap& map, int32_t origin_q8, int32_t samples) noexcept
      : map_(map), origin_q8_(origin_q8), samples_(samples) {}

  // `sign` is -1 where points count down.
  int32_t to(int32_t at_q8, int32_t sign) noexcept {
    if (map_.count == 0) {
      return at_q8;
    }
    // Points of hostile fonts lie anywhere: modulo 2^32.
    const auto from = static_cast<int32_t>(
        (static_cast<uint32_t>(at_q8) - static_cast<uint32_t>(origin_q8_)) *
        static_cast<uint32_t>(sign));
    int32_t px_q8 = from;
    if (samples_ != 1) {
      px_q8 = static_cast<int32_t>(int64_t{from} * 21846 >> 16);
    }
    return static_cast<int32_t>(static_cast<uint32_t>(origin_q8_) +
                                static_cast<uint32_t>(map_.map(px_q8, knot_)) *
                                    static_cast<uint32_t>(sign * samples_));
  }

 private:
  const AxisMap& map_;
  int32_t origin_q8_;
  int32_t samples_;  // a pixel, 1 or 3
  int32_t knot_ = 0;
};

}  // namespace

void warp_points(const OpenGlyph& opened,
                 ScreenPoint* points,
                 const ScreenPoint* end) noexcept {
  const OutlineGlyph& glyph = opened.glyph;
  AxisWarp x(opened.warp->x, glyph.origin_x_q8(), opened.plan.columns);
  AxisWarp y(opened.warp->y, glyph.origin_y_q8(), opened.plan.rows);
  for (; points != end; ++points) {
    *points = ScreenPoint::at(x.to(points->x_q8, 1), y.to(points->y_q8(), -1),
                              points->kind());
  }
}

}  // namespace detail
}  // namespace inkcell
