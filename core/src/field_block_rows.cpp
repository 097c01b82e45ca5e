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
    if (rest == width_ - 1 && value >= page_.reach_q22 + track.margin_q22) {
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
// the most. How many there were.
__attribute__((noinline)) int32_t BlockPainter::draw_ramp(
    const Track& track, int32_t most) noexcept {
  const int32_t inside_q22 =
      track.is_wavy ? INT32_MAX : page_.reach_q22 + track.margin_q22;
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
  return most - left;
}

inline BlockPainter::Row BlockPainter::single_row(const Track& track) noexcept {
  const int32_t most = track.rest + 1;
  const int32_t solid = most - draw_ramp(track, most);
  if (track.is_left) {
    return {0, 0, solid, most};
  }
  return {width_ - most, width_ - solid, width_, width_};
}

// A field at a pixel of its row.
inline BlockPainter::Spot BlockPainter::spot_at(const Track& track,
                                                int32_t x) const noexcept {
  const int32_t way = x - x_of(track);
  return track.spot.plus(track.further.times(track.is_left ? -way : way));
}

// Draws pixels begin <= x < end of two fields, to the left if that is the way
// of both, up to where both are inside if they go one way. How many there were.
__attribute__((noinline)) int32_t BlockPainter::draw_both(
    const Track& a, const Track& b, int32_t begin, int32_t end) noexcept {
  const bool is_left = a.is_left && b.is_left;
  int32_t inside_q22 = INT32_MAX;
  if (a.is_left == b.is_left && !a.is_wavy && !b.is_wavy) {
    inside_q22 = page_.reach_q22 + greater(a.margin_q22, b.margin_q22);
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
    int32_t values[2] = {value_q22(bend_a, at_a), 0};
    int32_t value = values[0];
    if (value > outside_q22) {
      values[1] = value_q22(bend_b, at_b);
      const bool in_order = value <= values[1];
      value = in_order ? value : values[1];
      if (value >= inside_q22) {
        break;
      }
      // Where the greater one is farther from 0 no vertex is near.
      if (value < 0 && value > outside_q22 && values[0] + values[1] < 0) {
        const LeafFields leaf = {{a.unit, b.unit}, false, 2, sign_};
        value = rounded_at(
            page_, leaf, in_order ? 0 : 1, in_order ? 1 : 0, values,
            {place_.x_q8 + (static_cast<uint32_t>(x) << 8), place_.y_q8});
      }
    }
    buffer_[x] = coverage(value);
    x += is_left ? -1 : 1;
    at_a = at_a.plus(further_a);
    at_b = at_b.plus(further_b);
  } while (--left != 0);
  return end - begin - left;
}

// Leaves out what the field shows to be outside.
inline void BlockPainter::narrow(const Track& track,
                                 int32_t& begin,
                                 int32_t& end) const noexcept {
  if (track.is_left) {
    end = lesser(end, track.rest + 1);
  } else {
    begin = greater(begin, width_ - 1 - track.rest);
  }
}

// A row of two fields that both matter.
__attribute__((noinline)) BlockPainter::Row BlockPainter::pair_row(
    const Track& a, const Track& b) noexcept {
  int32_t begin = 0;
  int32_t end = width_;
  narrow(a, begin, end);
  narrow(b, begin, end);
  if (begin >= end) {
    return outside_row();
  }
  int32_t both_begin = begin;
  int32_t both_end = end;
  if (a.is_left != b.is_left && !a.is_wavy && !b.is_wavy) {
    both_end = begin + draw_ramp(a.is_left ? b : a, end - begin);
    both_begin = end - draw_ramp(a.is_left ? a : b, end - begin);
    if (both_end <= both_begin) {
      return {begin, both_end, both_begin, end};
    }
  }
  const int32_t drawn = draw_both(a, b, both_begin, both_end);
  if (a.is_left && b.is_left) {
    return {begin, begin, end - drawn, end};
  }
  return {begin, drawn < both_end - both_begin ? begin + drawn : end, end, end};
}

// A row of three fields that all matter.
__attribute__((noinline)) BlockPainter::Row BlockPainter::triple_row(
    const LeafFields& leaf) noexcept {
  const int32_t reach_q22 = page_.reach_q22;
  int32_t begin = 0;
  int32_t end = width_;
  Spot spots[3];
  const uint32_t least = leaf.is_nested ? 1 : 3;
  for (uint32_t i = 0; i < least; ++i) {
    narrow(tracks_[i], begin, end);
  }
  if (begin >= end) {
    return outside_row();
  }
  for (uint32_t i = 0; i < 3; ++i) {
    spots[i] = spot_at(tracks_[i], begin);
  }
  for (int32_t x = begin; x < end; ++x) {
    int32_t values[3];
    for (uint32_t i = 0; i < 3; ++i) {
      const Track& track = tracks_[i];
      values[i] = value_q22(track.bend, spots[i]);
      spots[i] = track.is_left ? spots[i].minus(track.further)
                               : spots[i].plus(track.further);
    }
    // Roundings change values on the ramp only, but there by any amount.
    const int32_t others = leaf.is_nested ? greater(values[1], values[2])
                                          : lesser(values[1], values[2]);
    int32_t value = lesser(values[0], others);
    if (value < reach_q22 && value > -reach_q22) {
      value = combined(
          page_, leaf, values,
          {place_.x_q8 + (static_cast<uint32_t>(x) << 8), place_.y_q8});
    }
    buffer_[x] = coverage(value);
  }
  return {begin, end, end, end};
}

// A row of several fields: most of them matter in a part of their cell only.
__attribute__((noinline)) BlockPainter::Row BlockPainter::several_row(
    const LeafFields& leaf) noexcept {
  Side sides[3] = {};
  for (uint32_t i = 0; i < leaf.count; ++i) {
    sides[i] = follow(tracks_[i]);
  }
  if (sides[0] == Side::outside) {
    return outside_row();
  }
  const Track* some[3];
  uint32_t count = 0;
  if (leaf.count == 2) {
    if (sides[1] == Side::outside) {
      return outside_row();
    }
    if (sides[0] == Side::edge && sides[1] == Side::edge) {
      return pair_row(tracks_[0], tracks_[1]);
    }
  }
  if (leaf.is_nested) {
    if (sides[1] == Side::outside && sides[2] == Side::outside) {
      return outside_row();
    }
    if (sides[1] != Side::inside && sides[2] != Side::inside) {
      if (sides[0] == Side::inside ||
          (sides[1] == Side::edge && sides[2] == Side::edge)) {
        return triple_row(leaf);
      }
      some[count++] = tracks_ + (sides[1] == Side::edge ? 1 : 2);
    }
    if (sides[0] == Side::edge) {
      some[count++] = tracks_;
    }
  } else {
    for (uint32_t i = 0; i < leaf.count; ++i) {
      if (sides[i] == Side::outside) {
        return outside_row();
      }
      if (sides[i] == Side::edge) {
        some[count++] = tracks_ + i;
      }
    }
  }
  if (count == 0) {
    return inside_row();
  }
  if (count == 1) {
    return single_row(*some[0]);
  }
  return count == 2 ? pair_row(*some[0], *some[1]) : triple_row(leaf);
}

}  // namespace detail
}  // namespace inkcell
