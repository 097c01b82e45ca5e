#include "place/cell_map.hpp"

#include "base/math.hpp"

namespace inkcell {
namespace detail {
namespace {

// px times a step, modulo 2^32; rounded down. [Q10, Qn -> Qn]
inline uint32_t product(int32_t px_q10, int32_t step) noexcept {
#if defined(__ARM_ARCH_6M__)
  // No long products there: px and 1/1024 px, and of the latter's product the
  // upper and the lower part.
  const auto whole = static_cast<uint32_t>(px_q10 >> 10);
  const auto rest = static_cast<uint32_t>(px_q10 & 1023);
  const auto size = static_cast<uint32_t>(step);
  return whole * size +
         ((rest * (size >> 8) + (rest * (size & 255) >> 8)) >> 2);
#else
  return static_cast<uint32_t>((int64_t{px_q10} * step) >> 10);
#endif
}

// Samples along an axis of the glyph, counted the way it leads.
struct Axis {
  int32_t begin;
  int32_t end;
  int32_t origin_q10;  // [samples]
  int32_t step_q16;    // of a sample [u]
  int32_t first_q16;   // where the centres of the first and last one are [u]
  int32_t last_q16;
};

// Leaves those whose centres lie in [low_q16, high_q16). [u] False: there are
// none. `size_q6`: samples to the em.
__attribute__((always_inline)) inline bool clip_axis(Axis& axis,
                                                     int32_t low_q16,
                                                     int32_t high_q16,
                                                     int32_t size_q6) noexcept {
  // The sample at a place, or one of those beside it: steps that are rounded
  // down lead up to 1/4 px astray at the ends of the largest grid.
  const auto sample_at = [&](int32_t place_u) noexcept {
    return (axis.origin_q10 + ((place_u * size_q6) >> 6)) >> 10;
  };
  int32_t begin = max(axis.begin, sample_at(low_q16 >> 16));
  int32_t end = min(axis.end, sample_at((high_q16 >> 16) + 1) + 1);
  if (begin >= end) {
    return false;
  }
  const int32_t step = axis.step_q16;
  int32_t first = wrapped(product(begin * 1024 + 512 - axis.origin_q10, step));
  int32_t last = first + (end - begin - 1) * step;
  for (; last >= high_q16; last -= step) {
    --end;
  }
  for (; first < low_q16; first += step) {
    ++begin;
  }
  axis.begin = begin;
  axis.end = end;
  axis.first_q16 = first;
  axis.last_q16 = last;
  return begin < end;
}

// From `low` to `high`. [px, Q10]
struct Extent {
  int32_t low;
  int32_t high;
};

// From one place in the glyph to another along an axis of the screen. Not
// inline: products of 64 bits are large.
__attribute__((noinline)) Extent extent_of(Extent place_q10,
                                           Fixed<int32_t, 30> factor) noexcept {
  const auto low =
      static_cast<int32_t>((int64_t{place_q10.low} * factor.raw) >> 30);
  const auto high =
      static_cast<int32_t>((int64_t{place_q10.high} * factor.raw) >> 30);
  return low < high ? Extent{low, high} : Extent{high, low};
}

// (right px to the right + up px up) of a step, modulo 2^54. Not inline:
// products of 64 bits are large.
__attribute__((noinline)) int64_t sum_of(int64_t right_q10,
                                         int32_t right,
                                         int64_t up_q10,
                                         int32_t up) noexcept {
  const uint64_t products =
      static_cast<uint64_t>(right_q10) * static_cast<uint64_t>(right) +
      static_cast<uint64_t>(up_q10) * static_cast<uint64_t>(up);
  return static_cast<int64_t>(products) >> 10;
}

bool fits(int64_t value) noexcept {
  return value >= INT32_MIN && value <= INT32_MAX;
}

}  // namespace

bool find_point(const GlyphField& field,
                const GlyphStep& right,
                const GlyphStep& up,
                const FinePoint& origin,
                int32_t x,
                int32_t y,
                GlyphPoint& out) noexcept {
  // Far from anything to see it is clamped, to stay within 64 bits once
  // multiplied.
  constexpr int64_t kFar = int64_t{1} << 37;
  const int64_t right_q10 =
      clamp(int64_t{x} * 1024 + 512 - origin.x_q10, -kFar, kFar);
  const int64_t up_q10 =
      clamp(origin.y_q10 - (int64_t{y} * 1024 + 512), -kFar, kFar);
  const int64_t x_u = sum_of(right_q10, right.x_q16, up_q10, up.x_q16);
  const int64_t y_u = sum_of(right_q10, right.y_q16, up_q10, up.y_q16);
  out.x_q16 = static_cast<uint32_t>(x_u) - corner_q16(field.x0_u);
  out.y_q16 = static_cast<uint32_t>(y_u) - corner_q16(field.y0_u);
  out.x_q20 =
      static_cast<uint32_t>(sum_of(right_q10, right.x_q20, up_q10, up.x_q20)) +
      kHalfQ20;
  out.y_q20 =
      static_cast<uint32_t>(sum_of(right_q10, right.y_q20, up_q10, up.y_q20)) +
      kHalfQ20;
  return fits(x_u) && fits(y_u);
}

Rect limits_of(const CellMap& map) noexcept {
  const GlyphField& field = map.field;
  const InkBox& ink = field.ink;
  const int32_t reach_u = (map.reach_u_q10 + 1023) >> 10;
  const int32_t beyond_u = map.beyond_u;
  return {max(field.x0_u - beyond_u, ink.x0_u - reach_u),
          max(field.y0_u - beyond_u, ink.y0_u - reach_u),
          min(field.x1_u() + beyond_u, ink.x1_u + reach_u),
          min(field.y1_u() + beyond_u, ink.y1_u + reach_u)};
}

// Not inline: what it needs of the stack is free again when pixels are drawn.
__attribute__((noinline)) bool clip_upright(CellMap& map,
                                            const Rect& window) noexcept {
  const GlyphField& field = map.field;
  const int32_t size_q6 = map.style.size().raw;
  Axis across = {window.x0, window.x1, map.x_q10, map.right.x_q16, 0, 0};
  // Rows are counted upwards; the one above the screen is 0.
  Axis along = {-window.y1, -window.y0, -map.y_q10, map.up.y_q16, 0, 0};
  // As far from the ink as the filter reaches nothing shows. Reaches are 2^10 u
  // at the most.
  const InkBox& ink = field.ink;
  const int32_t reach_q16 = map.reach_u_q10 * 64;
  const int32_t beyond_u = map.beyond_u;
  const auto low = [=](int32_t grid_u, int32_t ink_u) noexcept {
    return max((grid_u - beyond_u) * (1 << 16),
               ink_u * (1 << 16) - reach_q16 + 1);
  };
  const auto high = [=](int32_t grid_u, int32_t ink_u) noexcept {
    return min((grid_u + beyond_u) * (1 << 16), ink_u * (1 << 16) + reach_q16);
  };
  map.samples = {};
  if (!clip_axis(across, low(field.x0_u, ink.x0_u),
                 high(field.x1_u(), ink.x1_u), size_q6) ||
      !clip_axis(along, low(field.y0_u, ink.y0_u), high(field.y1_u(), ink.y1_u),
                 size_q6)) {
    return false;
  }
  map.samples = {across.begin, -along.end, across.end, -along.begin};
  map.first = {
      static_cast<uint32_t>(across.first_q16) - corner_q16(field.x0_u),
      static_cast<uint32_t>(along.last_q16) - corner_q16(field.y0_u),
      product(across.begin * 1024 + 512 - across.origin_q10, map.right.x_q20) +
          kHalfQ20,
      product((along.end - 1) * 1024 + 512 - along.origin_q10, map.up.y_q20) +
          kHalfQ20};
  map.is_near = true;
  return true;
}

bool clip_slanted(CellMap& map, const Rect& window) noexcept {
  map.samples = {};
  const Rect limits = limits_of(map);
  if (is_empty(limits)) {
    return false;
  }
  const int32_t size_q6 = map.style.size().raw;
  // Below 2^30.
  const Extent x = {(limits.x0 * size_q6) >> 6, (limits.x1 * size_q6) >> 6};
  const Extent y = {(limits.y0 * size_q6) >> 6, (limits.y1 * size_q6) >> 6};
  const TextStyle::Axes& axes = map.style.axes();
  const Extent x_right = extent_of(x, axes.x_right);
  const Extent x_up = extent_of(x, axes.x_up);
  const Extent y_right = extent_of(y, axes.y_right);
  const Extent y_up = extent_of(y, axes.y_up);
  const auto sample_at = [](int32_t origin_q10, int32_t px_q10) noexcept {
    return (origin_q10 + px_q10) >> 10;
  };
  // A pixel generous on each side, because steps are rounded.
  map.samples =
      intersect({sample_at(map.x_q10, x_right.low + y_right.low) - 1,
                 sample_at(map.y_q10, -x_up.high - y_up.high) - 1,
                 sample_at(map.x_q10, x_right.high + y_right.high) + 2,
                 sample_at(map.y_q10, -x_up.low - y_up.low) + 2},
                window);
  const Rect& box = map.samples;
  if (is_empty(box)) {
    return false;
  }
  // Samples around turned grids are near; in corners around a stretched one
  // they may not be.
  map.is_near = map.find(box.x1, box.y0, map.first) &&
                map.find(box.x0, box.y1, map.first) &&
                map.find(box.x1, box.y1, map.first);
  map.is_near = map.find(box.x0, box.y0, map.first) && map.is_near;
  return true;
}

}  // namespace detail
}  // namespace inkcell
