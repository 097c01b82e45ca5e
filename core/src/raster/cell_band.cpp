// Which primitives of a leaf matter in its part of a tile, and how fast they
// change. What a primitive's slopes allow tells how far from 0 it must be in
// the middle to leave all of the leaf saturated.
#include "raster/cell_band.hpp"

#include "cells/leaf_reader.hpp"
#include "place/cell_raster.hpp"

namespace inkcell {
namespace detail {
namespace {

// More than what the rounding of a bent field makes. [px, Q22]
constexpr uint32_t kArcMarginQ22 = 1 << 17;
// What a bent field must gain from a point to the next one to be known to gain
// in spite of that. [px, Q14]
constexpr int32_t kArcRiseQ14 = 1 << 10;
// The same of all fields along steps that are rounded.
constexpr int32_t kStepRiseQ14 = 1 << 10;

// By how much what has this gradient grows in a step, less than 2 px along each
// axis.
inline int32_t slope_along_q14(const Vector& gradient_q14,
                               const GlyphStep& step) noexcept {
  const uint32_t x_q27 =
      times(gradient_q14.x, static_cast<uint32_t>(step.x_q20 >> 7));
  const uint32_t y_q27 =
      times(gradient_q14.y, static_cast<uint32_t>(step.y_q20 >> 7));
  return wrapped(x_q27 + y_q27) >> 13;
}

// After how many points a slope, 2^8 at the least, has gained 1/64 px, or
// fewer. [Q15]
inline uint16_t skip_q15(uint32_t slope_q14) noexcept {
#if defined(__ARM_ARCH_6M__)
  // No division there. 1/m is no less than 2r - m r r for any r; m is 1 to 2,
  // and r a line close to 1/m. Steeper slopes, which only bends make, skip
  // nothing.
  int32_t log2 = 0;
  if (slope_q14 >= 1 << 15) {
    return 0;
  }
  while (slope_q14 < 1 << 14) {
    slope_q14 <<= 1;
    ++log2;
  }
  const uint32_t r_q14 = 23750 - (slope_q14 >> 1);
  const uint32_t rest_q14 = (1 << 15) - ((slope_q14 * r_q14 >> 14) + 1);
  return static_cast<uint16_t>(r_q14 * rest_q14 >> (19 - log2));
#else
  return static_cast<uint16_t>((uint32_t{1} << 23) / slope_q14);
#endif
}

// Of larger ones sums might wrap. [px]
constexpr uint32_t kMostReachQ22 = 1 << 30;

// Whether w passes 256 px or k w 1 where w differs by `way_q8` at the most:
// products may wrap then.
inline bool may_wrap(const ArcValue& arc,
                     const PixelPlace& middle,
                     uint32_t way_q8,
                     int32_t bend_shift) noexcept {
  const uint32_t most_q8 =
      way_q8 + static_cast<uint32_t>(abs(wrapped(arc.along_q8(middle))));
  // 1/16 of what is below 2^20, rounded up: the product stays below 2^32.
  const uint32_t part = (static_cast<uint32_t>(abs(arc.bend)) >> 4) + 1;
  return most_q8 >= 1 << 16 || (part * most_q8) >> (bend_shift + 11) != 0;
}

}  // namespace

// What a primitive shows of a leaf's samples. If they are on both sides of its
// edge `slopes` is widened to hold its own. A function for each form: lines
// take less than half of what arcs do.
template <bool kIsArc>
__attribute__((noinline)) CellBand::Side CellBand::side_as(
    PrimitiveRef primitive,
    const Extent& all,
    int32_t sign,
    Slopes& slopes) const noexcept {
  // Values may wrap here: report unbounded slopes, which disables skipping.
  const auto disable = [&slopes]() noexcept {
    constexpr int32_t kSteepestQ14 = 1 << 24;
    slopes = {-kSteepestQ14, kSteepestQ14};
    return Side::edge;
  };
  const Vector normal_q14 = normal_of(record_of(primitive));
  int32_t value = 0;
  auto reach_q22 = static_cast<uint32_t>(prune_reach_q22_);
  Vector slope_q14 = normal_q14;
  uint32_t more_q14 = 0;   // by how much the bend changes it, to both sides
  int32_t change_q14 = 0;  // what of this lies along the row
  if (!kIsArc) {
    value = LineValue(primitive, scale_, 0).at(all.middle, 0, 0);
  } else {
    const ArcValue arc(primitive, scale_, 0);
    const auto nx = static_cast<uint32_t>(abs(normal_q14.x));
    const auto ny = static_cast<uint32_t>(abs(normal_q14.y));
    const uint32_t way_q8 = (nx * all.half_y_q8 + ny * all.half_x_q8) >> 14;
    if (__builtin_expect(may_wrap(arc, all.middle, way_q8, bend_shift()), 0)) {
      return disable();
    }
    value = arc.at(all.middle, bend_shift(), 0);
    slope_q14 = arc.gradient_q14(all.middle, bend_shift());
    more_q14 = times(abs(arc.bend), way_q8) >> bend_shift();
    reach_q22 += kArcMarginQ22 + ((more_q14 * way_q8) >> 1);
    change_q14 = (wrapped(ny * more_q14) >> 14) + kArcRiseQ14;
  }
  reach_q22 += times(abs(slope_q14.x), all.half_x_q8) +
               times(abs(slope_q14.y), all.half_y_q8);
  if (__builtin_expect(reach_q22 >= kMostReachQ22, 0)) {
    return disable();
  }
  const int32_t limit = wrapped(reach_q22);
  value = with_sign(value, sign);
  if (value >= limit) {
    return value <= INT32_MAX - limit ? Side::inside : disable();
  }
  if (value <= -limit) {
    return value >= limit - INT32_MAX ? Side::outside : disable();
  }
  int32_t along_q14 = slope_q14.x;
  if (__builtin_expect(all.right != nullptr, 0)) {
    along_q14 = slope_along_q14(slope_q14, *all.right);
    // No step is longer than 3 px.
    change_q14 = 3 * wrapped(more_q14) + kStepRiseQ14;
  }
  along_q14 = with_sign(along_q14, sign);
  slopes.least = min(slopes.least, along_q14 - change_q14);
  slopes.greatest = max(slopes.greatest, along_q14 + change_q14);
  return Side::edge;
}

inline CellBand::Side CellBand::side_of(PrimitiveRef primitive,
                                        const Extent& all,
                                        int32_t sign,
                                        Slopes& slopes) const noexcept {
  return arc_bit(primitive) == 0 ? side_as<false>(primitive, all, sign, slopes)
                                 : side_as<true>(primitive, all, sign, slopes);
}

// Of a leaf whose minimum counts.
inline CellBand::Side CellBand::keep_minimum(TileLeaf& leaf,
                                             const Extent& all,
                                             Slopes& slopes) const noexcept {
  uint32_t kept = 0;
  for (uint32_t i = 0; i < leaf.count; ++i) {
    const Side side = side_of(leaf.parts[i], all, leaf.sign, slopes);
    if (side == Side::outside) {
      return side;
    }
    if (side == Side::edge) {
      leaf.parts[kept++] = leaf.parts[i];
    }
  }
  leaf.count = static_cast<uint8_t>(kept);
  return kept == 0 ? Side::inside : Side::edge;
}

// Of a leaf of which the minimum of the first and the maximum of the others
// counts.
inline CellBand::Side CellBand::keep_nested(TileLeaf& leaf,
                                            const Extent& all,
                                            Slopes& slopes) const noexcept {
  const Side first = side_of(leaf.parts[0], all, leaf.sign, slopes);
  if (first == Side::outside) {
    return first;
  }
  const Side second = side_of(leaf.parts[1], all, leaf.sign, slopes);
  const Side third = side_of(leaf.parts[2], all, leaf.sign, slopes);
  uint32_t kept = first == Side::edge ? 1 : 0;
  if (second != Side::inside && third != Side::inside) {
    if (second == Side::edge && third == Side::edge) {
      if (kept != 0) {
        return Side::edge;  // all three
      }
      // The greater of two: the least with the signs turned.
      leaf.sign = static_cast<int8_t>(~leaf.sign);
      leaf.parts[0] = leaf.parts[1];
      leaf.parts[1] = leaf.parts[2];
      kept = 2;
    } else if (second == Side::edge || third == Side::edge) {
      leaf.parts[kept++] = leaf.parts[second == Side::edge ? 1 : 2];
    } else {
      return Side::outside;
    }
  }
  leaf.is_nested = false;
  leaf.count = static_cast<uint8_t>(kept);
  return kept == 0 ? Side::inside : Side::edge;
}

__attribute__((noinline)) void CellBand::prune(
    TileLeaf& leaf, const Extent& all) const noexcept {
  const int32_t sign = leaf.sign;
  Slopes slopes = {INT32_MAX, INT32_MIN};
  const Side side = leaf.is_nested ? keep_nested(leaf, all, slopes)
                                   : keep_minimum(leaf, all, slopes);
  if (side != Side::edge) {
    leaf.count = 0;
    leaf.is_inside = (side == Side::inside) == (sign == 0);
    return;
  }
  constexpr uint32_t kFlattestQ14 = 1 << 8;
  const auto steepest =
      static_cast<uint32_t>(max(abs(slopes.least), abs(slopes.greatest)));
  leaf.skip_q15 = skip_q15(steepest > kFlattestQ14 ? steepest : kFlattestQ14);
  // Where all fields go one way what is left of them does.
  constexpr uint16_t kAll = UINT16_MAX;
  const uint16_t falls = slopes.greatest <= 0 ? kAll : 0;
  const uint16_t rises = slopes.least >= 0 ? kAll : 0;
  leaf.all_outside = sign == 0 ? falls : rises;
  leaf.all_inside = sign == 0 ? rises : falls;
}

CellBand::CellBand(const CellRaster& raster,
                   const CellMap& map,
                   const CoverageRamp& ramp,
                   const Stripes* stripes) noexcept
    : Csg(scale_of(map.style), reach_of(ramp)),
      map_(map),
      stripes_(stripes),
      ramp_(ramp),
      prune_reach_q22_(reach_q22_) {
  const int32_t high_q22 = ramp.high_q22();
  clamp_rounded(ramp.low_q22 - 1, high_q22);
  set_far(min(ramp.low_q22, 0), max(high_q22, 0));
  if (raster.stretching != nullptr) {
    set_stretching(*raster.stretching, map.style);
    prune_reach_q22_ = far_q22();
    set_far(-prune_reach_q22_, prune_reach_q22_);
  }
  // Steps of less than 2 px along each axis of the glyph, and distances that
  // leave room for sums.
  constexpr int32_t kLimit = 1 << 21;
  may_prune_ = prune_reach_q22_ < 1 << 29 && map.right.x_q20 < kLimit &&
               map.right.x_q20 > -kLimit && map.right.y_q20 < kLimit &&
               map.right.y_q20 > -kLimit;
}

void CellBand::paint_beyond(const GlyphPoint& middle,
                            uint8_t* line) const noexcept {
  const GlyphPoint near = in_grid(map_.field, middle);
  TileLeaf leaf;
  find_leaf(map_.field, near.x_q16 >> 16, near.y_q16 >> 16, leaf);
  leaf.width = 1;
  leaf.height = 1;
  leaf.line = line;
  leaf.spans = nullptr;
  if (leaf.count == 0 && !leaf.is_inside) {
    return;
  }
  stripes_->paint(*this, leaf, middle);
  const GlyphPoint& next = stripes_->next;
  GlyphPoint at = middle;
  at.x_q16 -= next.x_q16;
  at.y_q16 -= next.y_q16;
  for (int32_t i = 0; i != 3; ++i) {
    if (!is_in_grid(map_.field, at)) {
      line[i] = 0;
    }
    at.x_q16 += next.x_q16;
    at.y_q16 += next.y_q16;
  }
}

}  // namespace detail
}  // namespace inkcell
