// Rows of blocks in which several fields matter: each is followed to where its
// ramp begins, and only where ramps of two or three meet they are combined
// pixel by pixel.
#include "field_block.hpp"
#include "order.hpp"

namespace inkcell {
namespace detail {

// Goes on to the next row and to where the field's ramp begins there. What the
// field shows of it.
__attribute__((noinline)) BlockPainter::Side BlockPainter::follow(
    Track& track) const noexcept {
  const int32_t outside_q22 = outside_q22_ - track.margin_q22;
  const int32_t bend = track.bend;
  Spot spot = track.spot.minus(track.down);
  int32_t value = value_q22(bend, spot);
  int32_t rest = track.rest;
  Side side = Side::edge;
  if (value <= outside_q22) {
    side = Side::outside;
    while (rest != 0 && !track.is_wavy) {
      --rest;
      spot = spot.plus(track.further);
      if (value_q22(bend, spot) > outside_q22) {
        side = Side::edge;
        break;
      }
    }
  } else {
    while (rest != width_ - 1) {
      const Spot back = spot.minus(track.further);
      const int32_t before = value_q22(bend, back);
      if (before <= outside_q22) {
        break;
      }
      ++rest;
      spot = back;
      value = before;
    }
    if (rest == width_ - 1 && value >= reach_q22_ + track.margin_q22) {
      side = Side::inside;
    }
  }
  track.spot = spot;
  track.rest = static_cast<int8_t>(rest);
  return side;
}

// Where a field's first pixel of the row is.
inline int32_t BlockPainter::x_of(const Track& track) const noexcept {
  return track.is_left ? track.rest : width_ - 1 - track.rest;
}

// Draws from where a field's ramp begins to where it ends, but `most` pixels at
// the most. How many of them are left, which are inside.
__attribute__((noinline)) int32_t BlockPainter::draw_ramp(
    const Track& track, int32_t most) noexcept {
  const int32_t inside_q22 =
      track.is_wavy ? INT32_MAX : reach_q22_ + track.margin_q22;
  uint8_t* at = buffer_ + x_of(track);
  const int32_t step = track.is_left ? -1 : 1;
  const int32_t bend = track.bend;
  const Spot further = track.further;
  Spot spot = track.spot;
  int32_t left = most;
  do {
    const int32_t value = value_q22(bend, spot);
    if (value >= inside_q22) {
      break;
    }
    *at = coverage(value);
    at += step;
    spot = spot.plus(further);
  } while (--left != 0);
  return left;
}

// Leaves a row empty.
__attribute__((noinline)) void BlockPainter::set_outside() noexcept {
  row_ = row(width_, width_, width_, width_);
}

__attribute__((noinline)) void BlockPainter::single_row(
    const Track& track) noexcept {
  const int32_t most = track.rest + 1;
  const int32_t solid = draw_ramp(track, most);
  if (track.is_left) {
    row_ = row(0, 0, solid, most);
  } else {
    row_ = row(width_ - most, width_ - solid, width_, width_);
  }
}

// How many pixels a field is followed to a pixel of its row.
inline int32_t BlockPainter::way_to(const Track& track,
                                    int32_t x) const noexcept {
  const int32_t way = x - x_of(track);
  return track.is_left ? -way : way;
}

inline BlockPainter::Spot BlockPainter::spot_at(const Track& track,
                                                int32_t x) const noexcept {
  return track.spot.plus(track.further.times(way_to(track, x)));
}

// A field's gradient at a pixel of its row, without the leaf's sign.
__attribute__((noinline)) Vector BlockPainter::gradient_q14(
    const Track& track, int32_t x) const noexcept {
  const int32_t nx_q14 = wrapped(track.down.along_q22) >> 8;
  const int32_t right_q14 = wrapped(track.further.along_q22) >> 8;
  const int32_t ny_q14 = track.is_left ? right_q14 : -right_q14;
  if (track.bend == 0) {
    return {nx_q14, ny_q14};
  }
  const uint32_t along_q22 =
      track.spot.along_q22 + times(way_to(track, x), track.further.along_q22);
  const auto slope = static_cast<uint32_t>(slope_q15(track.bend, along_q22));
  return {nx_q14 - (wrapped(times(ny_q14, slope)) >> 14),
          ny_q14 + (wrapped(times(nx_q14, slope)) >> 14)};
}

// The lesser of two values at a pixel, rounded at the vertex of their fields.
__attribute__((noinline)) int32_t BlockPainter::rounded(
    const Track& lesser, const Track& greater, int32_t x) const noexcept {
  return rounded_q22(lesser.value_q22, gradient_q14(lesser, x),
                     greater.value_q22, gradient_q14(greater, x));
}

// The lesser of two values, rounded where that changes coverage: where the
// greater one is farther from 0 no vertex is near.
inline int32_t BlockPainter::least(const Track& a,
                                   const Track& b,
                                   int32_t x) const noexcept {
  const bool in_order = a.value_q22 <= b.value_q22;
  const Track& low = in_order ? a : b;
  const Track& high = in_order ? b : a;
  const int32_t value = low.value_q22;
  if (value < 0 && value > -reach_q22_ && value + high.value_q22 < 0) {
    return rounded(low, high, x);
  }
  return value;
}

// The distance of three fields from their values, which may be changed.
__attribute__((noinline)) int32_t BlockPainter::least_of_three(
    int32_t x) noexcept {
  Track* first = tracks_;
  Track* second = tracks_ + 1;
  Track* const third = tracks_ + 2;
  if (is_nested_) {
    second->value_q22 = with_sign(second->value_q22, -1);
    third->value_q22 = with_sign(third->value_q22, -1);
    const int32_t inner = with_sign(least(*second, *third, x), -1);
    second = second->value_q22 <= third->value_q22 ? second : third;
    second->value_q22 = inner;
  } else if (first->value_q22 > second->value_q22 &&
             first->value_q22 > third->value_q22) {
    first = third;  // without the greatest
  } else if (second->value_q22 > third->value_q22) {
    second = third;
  }
  return least(*first, *second, x);
}

// Draws pixels begin <= x < end of two fields, to the left if that is the way
// of both, up to where both are inside if they go one way. How many are left.
__attribute__((noinline)) int32_t BlockPainter::draw_both(
    Track& a, Track& b, int32_t begin, int32_t end) noexcept {
  const bool is_left = a.is_left && b.is_left;
  int32_t inside_q22 = INT32_MAX;
  if (a.is_left == b.is_left && !a.is_wavy && !b.is_wavy) {
    inside_q22 = reach_q22_ + greater(a.margin_q22, b.margin_q22);
  }
  int32_t x = is_left ? end - 1 : begin;
  Spot at_a = spot_at(a, x);
  Spot at_b = spot_at(b, x);
  const Spot further_a = a.further.times(a.is_left == is_left ? 1 : -1);
  const Spot further_b = b.further.times(b.is_left == is_left ? 1 : -1);
  const int32_t bend_a = a.bend;
  const int32_t bend_b = b.bend;
  const int32_t outside_q22 = outside_q22_;
  int32_t left = end - begin;
  do {
    const int32_t value_a = value_q22(bend_a, at_a);
    int32_t value = value_a;
    if (value > outside_q22) {
      const int32_t value_b = value_q22(bend_b, at_b);
      value = lesser(value, value_b);
      if (value >= inside_q22) {
        break;
      }
      // Where the greater one is farther from 0 no vertex is near.
      if (value < 0 && value > outside_q22 && value_a + value_b < 0) {
        a.value_q22 = value_a;
        b.value_q22 = value_b;
        value = value_a <= value_b ? rounded(a, b, x) : rounded(b, a, x);
      }
    }
    buffer_[x] = coverage(value);
    x += is_left ? -1 : 1;
    at_a = at_a.plus(further_a);
    at_b = at_b.plus(further_b);
  } while (--left != 0);
  return left;
}

// The pixels of a row that a field does not show to be outside.
inline int32_t BlockPainter::begin_of(const Track& track) const noexcept {
  return track.is_left ? 0 : width_ - 1 - track.rest;
}
inline int32_t BlockPainter::end_of(const Track& track) const noexcept {
  return track.is_left ? track.rest + 1 : width_;
}

// A row of two fields that both matter.
__attribute__((noinline)) void BlockPainter::pair_row(Track& a,
                                                      Track& b) noexcept {
  const int32_t begin = greater(begin_of(a), begin_of(b));
  const int32_t end = lesser(end_of(a), end_of(b));
  if (begin >= end) {
    set_outside();
    return;
  }
  // Where ramps that lead towards each other meet they are drawn together;
  // where they do not all between them is solid.
  int32_t both_begin = begin;
  int32_t both_end = end;
  if (a.is_left != b.is_left && !a.is_wavy && !b.is_wavy) {
    both_end -= draw_ramp(a.is_left ? b : a, end - begin);
    both_begin += draw_ramp(a.is_left ? a : b, end - begin);
  }
  int32_t solid_begin = both_end;
  int32_t solid_end = both_begin;
  if (both_begin < both_end) {
    const int32_t solid = draw_both(a, b, both_begin, both_end);
    const bool is_left = a.is_left && b.is_left;
    solid_begin = is_left ? begin : end - solid;
    solid_end = is_left ? begin + solid : end;
  }
  row_ = row(begin, solid_begin, solid_end, end);
}

// A row of three fields that all matter.
__attribute__((noinline)) void BlockPainter::triple_row() noexcept {
  int32_t begin = 0;
  int32_t end = width_;
  const uint32_t least = is_nested_ ? 1 : 3;
  for (uint32_t i = 0; i < least; ++i) {
    begin = greater(begin, begin_of(tracks_[i]));
    end = lesser(end, end_of(tracks_[i]));
  }
  if (begin >= end) {
    set_outside();
    return;
  }
  row_ = row(begin, end, end, end);
  Spot spots[3];
  for (uint32_t i = 0; i < 3; ++i) {
    spots[i] = spot_at(tracks_[i], begin);
  }
  for (int32_t x = begin; x < end; ++x) {
    for (uint32_t i = 0; i < 3; ++i) {
      Track& track = tracks_[i];
      track.value_q22 = value_q22(track.bend, spots[i]);
      spots[i] = track.is_left ? spots[i].minus(track.further)
                               : spots[i].plus(track.further);
    }
    // Roundings change values on the ramp only, but there by any amount.
    const int32_t b = tracks_[1].value_q22;
    const int32_t c = tracks_[2].value_q22;
    int32_t value =
        lesser(tracks_[0].value_q22, is_nested_ ? greater(b, c) : lesser(b, c));
    if (value < reach_q22_ && value > -reach_q22_) {
      value = least_of_three(x);
    }
    buffer_[x] = coverage(value);
  }
}

// Goes on to the next row of several fields. Most of them matter in a part of
// their cell only; returns the set of those that do.
__attribute__((noinline)) uint32_t BlockPainter::follow_all() noexcept {
  uint32_t edges = 0;
  uint32_t outsides = 0;
  for (uint32_t i = 0; i < count_; ++i) {
    const Side side = follow(tracks_[i]);
    if (side == Side::edge) {
      edges |= 1u << i;
    } else if (side == Side::outside) {
      outsides |= 1u << i;
    }
  }
  if (!is_nested_) {
    return outsides != 0 ? kNone : edges;
  }
  constexpr uint32_t kInner = 6;  // the greater of them counts
  if ((outsides & 1) != 0 || (outsides & kInner) == kInner) {
    return kNone;
  }
  if (((edges | outsides) & kInner) != kInner) {
    return edges & 1;
  }
  return (edges & kInner) == kInner ? kAll : edges;
}

}  // namespace detail
}  // namespace inkcell
