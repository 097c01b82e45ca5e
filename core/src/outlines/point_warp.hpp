// Grid fitting of outlines: points that give way to the grid of pixels.
#pragma once

#include <stdint.h>

#include "inkcell/row_map.hpp"
#include "outlines/screen_point.hpp"

namespace inkcell {
namespace detail {

// A monotone piecewise-linear map of one coordinate: what lies at `from` goes
// to `to`, and beyond the outer knots all shifts as they do.
class AxisWarp {
 public:
  // The identity.
  void clear() noexcept { count_ = 0; }
  // Heights in the glyph to heights on the screen: the inverse of `rows`, y up,
  // as rows of samples, y down. `baseline_q8` is the row of height 0; there are
  // `samples` of them a pixel.
  void set(const RowMap& rows, int32_t baseline_q8, int32_t samples) noexcept;

  bool is_identity() const noexcept { return count_ == 0; }
  int32_t map(int32_t at_q8) const noexcept;

 private:
  struct Knot {
    int32_t from_q8;
    int32_t to_q8;
    int32_t slope_q12;  // up to the next knot
  };
  Knot knots_[RowMap::kMaxKnots];  // ascending
  int32_t count_;
};

// A map of each coordinate. Lies in RAM that is lent as bytes.
struct __attribute__((may_alias)) PointWarp {
  AxisWarp x;
  AxisWarp y;

  void apply(ScreenPoint* points, const ScreenPoint* end) const noexcept;
};

}  // namespace detail
}  // namespace inkcell
