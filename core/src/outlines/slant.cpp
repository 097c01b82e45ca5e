#include "outlines/slant.hpp"

#include "outlines/outline_glyph.hpp"

namespace inkcell::detail {
namespace {

// A factor of at most 1 or so. [Q30]
int32_t times_q30(int32_t scale, int32_t factor_q30) noexcept {
  return static_cast<int32_t>((int64_t{scale} * factor_q30 + (1 << 29)) >> 30);
}

bool map_slanted(const Style& style, OutlineMap& map) noexcept {
  const int32_t scale = map.axes[0].per_x;
  const Style::Axes& axes = style.axes();
  map = {
      {{times_q30(scale, axes.x_right.raw), times_q30(scale, axes.y_right.raw)},
       {-times_q30(scale, axes.x_up.raw), -times_q30(scale, axes.y_up.raw)}}};
  return (axes.x_right.raw >> 15) * int64_t{axes.y_up.raw >> 15} <
         (axes.x_up.raw >> 15) * int64_t{axes.y_right.raw >> 15};
}

// (a p + b q) / 2^30, for any a and b below 2^42, p and q below 2^31. Not
// inline for its size.
__attribute__((noinline)) int64_t turned(int64_t a,
                                         int64_t p,
                                         int64_t b,
                                         int64_t q) noexcept {
  // The products pass 64 bits, those of the halves do not.
  constexpr int64_t kLow = (1 << 20) - 1;
  const int64_t high = (a >> 20) * p + (b >> 20) * q;
  const int64_t low = (a & kLow) * p + (b & kLow) * q;
  return (high + (low >> 20)) >> 10;
}

FinePoint place_slanted(const Style& style,
                        const FinePoint& origin,
                        int64_t along_q10,
                        int64_t across_q10) noexcept {
  const Style::Axes& axes = style.axes();
  return {origin.x_q10 +
              turned(along_q10, axes.x_right.raw, across_q10, axes.y_right.raw),
          origin.y_q10 -
              turned(along_q10, axes.x_up.raw, across_q10, axes.y_up.raw)};
}

}  // namespace

const Slant kSlant = {map_slanted, place_slanted};

}  // namespace inkcell::detail
