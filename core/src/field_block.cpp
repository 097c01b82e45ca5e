// A block's fields are set up at its upper left pixel and then followed by
// addition, exact modulo 2^32, so that no pixel depends on where a window cuts
// the cell. What a field's slopes allow within the block tells how far from 0
// it must be to leave a whole row, or the whole block, saturated; such fields
// are dropped or decide alone. What is left is followed along the row, and
// where it is saturated as many pixels are skipped as its slope allows.
//
// What is not inline keeps the frames on the stack small.
#include "field_block.hpp"

#include "order.hpp"

namespace inkcell {
namespace detail {
namespace {

// Roundings of bent fields do not reach so far. [px, Q22]
constexpr int32_t kArcMargin = 1 << 18;

// Of a steeper field nothing is known of the rest of a row. [px per px]
constexpr int32_t kMaxSlopeQ14 = 2 << 14;

// One less below 0: bytes may make any value, also the least.
int32_t size_of(int32_t value) noexcept {
  return value < 0 ? ~value : value;
}

// From the least to the greatest value of something linear over a block.
struct Reach {
  int32_t low;
  int32_t high;

  Reach(uint32_t first, uint32_t right, uint32_t down) noexcept {
    const int32_t a = wrapped(right);
    const int32_t b = wrapped(down);
    low = wrapped(first + static_cast<uint32_t>(lesser(a, 0)) +
                  static_cast<uint32_t>(lesser(b, 0)));
    high = wrapped(first + static_cast<uint32_t>(greater(a, 0)) +
                   static_cast<uint32_t>(greater(b, 0)));
  }
  void widen(int32_t down, int32_t up) noexcept {
    low = wrapped(static_cast<uint32_t>(low) + static_cast<uint32_t>(down));
    high = wrapped(static_cast<uint32_t>(high) + static_cast<uint32_t>(up));
  }
};

}  // namespace

void BlockPainter::fill(const Block& block) noexcept {
  for (int32_t row = block.top; row < block.bottom; ++row) {
    page_.writer.go_to_row(y0_ + row);
    page_.writer.solid(x0_ + block.left, block.right - block.left);
    page_.writer.flush();
  }
}

// Sets a field up at the block's upper left pixel. What it shows of the block.
BlockPainter::Side BlockPainter::set_up(Track& track,
                                        int32_t sign,
                                        const Block& block) noexcept {
  const int32_t bend_log2 = page_.scale.bend_log2;
  const auto wide = static_cast<uint32_t>(block.right - block.left - 1);
  const auto high = static_cast<uint32_t>(block.bottom - block.top - 1);
  const PixelPlace place = place_of(block);
  FieldTerm term;
  set_up_term(term, page_.field, track.unit, place.x_q8, place.y_q8,
              page_.scale);
  track.row.plane_q22 = term.plane_q22;
  track.row.along_q22 = term.along_q22;
  track.bend = term.bend;
  track.dx_q22 = static_cast<uint32_t>(term.nx_q14) << 8;
  track.dy_q22 = static_cast<uint32_t>(term.ny_q14) << 8;
  Reach value(track.row.plane_q22, wide * track.dx_q22,
              0u - high * track.dy_q22);
  // The slopes along a row. [px per px, Q14]
  int32_t least = term.nx_q14;
  int32_t most = term.nx_q14;
  int32_t margin = 0;
  if (term.bend != 0) {
    const Reach along(track.row.along_q22, 0u - wide * track.dy_q22,
                      0u - high * track.dx_q22);
    FieldTerm end = term;
    end.plane_q22 = 0;
    end.along_q22 = static_cast<uint32_t>(along.low);
    const auto steep = [&end, bend_log2] {
      return wrapped(times(end.ny_q14,
                           static_cast<uint32_t>(end.slope_q15(bend_log2)))) >>
             14;
    };
    const int32_t low_slope = steep();
    const int32_t low_sag = end.value_q22(bend_log2);
    end.along_q22 = static_cast<uint32_t>(along.high);
    const int32_t high_slope = steep();
    const int32_t high_sag = end.value_q22(bend_log2);
    least = term.nx_q14 - greater(low_slope, high_slope) - 1;
    most = term.nx_q14 - lesser(low_slope, high_slope) + 1;
    value.widen(lesser(lesser(low_sag, high_sag), 0),
                greater(greater(low_sag, high_sag), 0));
    margin = kArcMargin;
    margin_q22_ = kArcMargin;
  }
  const int32_t reach_q22 = page_.reach_q22 + margin;
  if (value.low >= reach_q22) {
    return sign == 0 ? Side::inside : Side::outside;
  }
  if (value.high <= -reach_q22) {
    return sign == 0 ? Side::outside : Side::inside;
  }
  const int32_t slope_q14 = greater(most, -least);
  slope_q14_ = greater(slope_q14_, slope_q14);
  if (slope_q14 > kMaxSlopeQ14) {
    track.inside_q22 = INT32_MAX;
    track.outside_q22 = -INT32_MAX;
    return Side::edge;
  }
  const auto width = static_cast<int32_t>(wide) << 8;
  const int32_t down_q22 = width * lesser(least, 0);
  const int32_t up_q22 = width * greater(most, 0);
  track.inside_q22 = reach_q22 + (sign == 0 ? -down_q22 : up_q22);
  track.outside_q22 = -reach_q22 + (sign == 0 ? -up_q22 : down_q22);
  return Side::edge;
}

// Sets up the fields of a leaf and keeps those that matter. What the block
// shows, as if the operator asked for the least.
__attribute__((noinline)) BlockPainter::Side BlockPainter::set_up_all(
    LeafFields& leaf, const Block& block) noexcept {
  slope_q14_ = 64;
  margin_q22_ = 0;
  Side sides[3];
  const uint32_t all = leaf.count;
  leaf.count = 0;
  for (uint32_t i = 0; i < all; ++i) {
    Track& track = tracks_[leaf.count];
    track.unit = leaf.units[i];
    sides[i] = set_up(track, leaf.sign, block);
    if (sides[i] == Side::outside && (i == 0 || !leaf.is_nested)) {
      return Side::outside;
    }
    if (sides[i] == Side::edge) {
      leaf.units[leaf.count++] = track.unit;
    }
  }
  if (leaf.is_nested) {
    const bool is_first_left = sides[0] == Side::edge;
    if (sides[1] == Side::outside && sides[2] == Side::outside) {
      return Side::outside;
    }
    if (sides[1] == Side::inside || sides[2] == Side::inside) {
      leaf.count = is_first_left ? 1 : 0;
    }
    leaf.is_nested = leaf.count == 3;
    if (leaf.count != 0 && !leaf.is_nested && !is_first_left) {
      // The greater of the others is all.
      leaf.sign = ~leaf.sign;
      for (uint32_t i = 0; i < leaf.count; ++i) {
        const int32_t inside_q22 = tracks_[i].inside_q22;
        tracks_[i].inside_q22 = -tracks_[i].outside_q22;
        tracks_[i].outside_q22 = -inside_q22;
      }
    }
  }
  return leaf.count == 0 ? Side::inside : Side::edge;
}

// How many pixels from one on show the same, given its value, which is beyond
// the ramp.
inline int32_t BlockPainter::skipped(int32_t value_q22) const noexcept {
  constexpr int32_t kMost = (1 << 14) - 1;
  const int32_t way_q8 =
      (size_of(value_q22) - page_.reach_q22 - margin_q22_) >> 14;
  if (way_q8 <= 0) {
    return 1;
  }
  return 1 +
         static_cast<int32_t>((static_cast<uint32_t>(lesser(way_q8, kMost)) *
                               pixels_per_slope_) >>
                              18);
}

// Pixels up to `end` that are all saturated.
inline void BlockPainter::saturate(int32_t x,
                                   int32_t end,
                                   bool inside) noexcept {
  page_.writer.saturated(x, end - x, inside == (sign_ == 0));
}

// A pixel of the ramp.
inline void BlockPainter::put(int32_t value_q22, int32_t x) noexcept {
  page_.writer.begin(x);
  page_.writer.append(page_.filter.coverage(with_sign(value_q22, sign_) >> 12));
}

inline bool BlockPainter::is_on_ramp(int32_t value_q22) const noexcept {
  return value_q22 < page_.reach_q22 && value_q22 > -page_.reach_q22;
}

// A row, or the rest of one, of one field.
__attribute__((noinline)) void BlockPainter::draw_single(const Track& track,
                                                         Spot spot,
                                                         int32_t x,
                                                         int32_t end) noexcept {
  while (true) {
    const int32_t value = value_q22(track, spot);
    if (is_on_ramp(value)) {
      put(value, x);
      if (++x == end) {
        return;
      }
      track.move_right(spot);
      continue;
    }
    if (value >= track.inside_q22 || value <= track.outside_q22) {
      saturate(x, end, value > 0);
      return;
    }
    const int32_t step = lesser(skipped(value), end - x);
    saturate(x, x + step, value > 0);
    x += step;
    if (x == end) {
      return;
    }
    track.move_right(spot, static_cast<uint32_t>(step));
  }
}

// The same of two, until one of them decides all that is left.
__attribute__((noinline)) void BlockPainter::draw_pair(const Track& a,
                                                       const Track& b,
                                                       PixelPlace place,
                                                       int32_t x,
                                                       int32_t end) noexcept {
  Spot at_a = a.row;
  Spot at_b = b.row;
  while (true) {
    int32_t values[2] = {value_q22(a, at_a), value_q22(b, at_b)};
    if (values[0] <= a.outside_q22 || values[1] <= b.outside_q22) {
      saturate(x, end, false);
      return;
    }
    if (values[0] >= a.inside_q22) {
      draw_single(b, at_b, x, end);
      return;
    }
    if (values[1] >= b.inside_q22) {
      draw_single(a, at_a, x, end);
      return;
    }
    const bool in_order = values[0] <= values[1];
    int32_t value = in_order ? values[0] : values[1];
    int32_t step = 1;
    if (is_on_ramp(value)) {
      // Where the greater one is farther from 0 no vertex is near.
      if (value < 0 && values[0] + values[1] < 0) {
        const LeafFields leaf = {{a.unit, b.unit}, false, 2, sign_};
        value = rounded_at(page_, leaf, in_order ? 0 : 1, in_order ? 1 : 0,
                           values, place);
      }
      put(value, x);
    } else {
      step = lesser(skipped(value), end - x);
      saturate(x, x + step, value > 0);
    }
    x += step;
    if (x == end) {
      return;
    }
    place.x_q8 += static_cast<uint32_t>(step) << 8;
    a.move_right(at_a, static_cast<uint32_t>(step));
    b.move_right(at_b, static_cast<uint32_t>(step));
  }
}

// A row of three fields that all matter.
__attribute__((noinline)) void BlockPainter::draw_triple(const LeafFields& leaf,
                                                         PixelPlace place,
                                                         int32_t x,
                                                         int32_t end) noexcept {
  uint32_t way = 0;
  while (x < end) {
    int32_t values[3];
    for (uint32_t i = 0; i < 3; ++i) {
      Spot spot = tracks_[i].row;
      tracks_[i].move_right(spot, way);
      values[i] = value_q22(tracks_[i], spot);
    }
    // Roundings change values on the ramp only, but there by any amount.
    const int32_t others = leaf.is_nested ? greater(values[1], values[2])
                                          : lesser(values[1], values[2]);
    const int32_t value = lesser(values[0], others);
    int32_t step = 1;
    if (is_on_ramp(value)) {
      put(combined(page_, leaf, values, place), x);
    } else {
      step = lesser(skipped(value), end - x);
      saturate(x, x + step, value > 0);
    }
    x += step;
    way += static_cast<uint32_t>(step);
    place.x_q8 += static_cast<uint32_t>(step) << 8;
  }
}

// What the fields of a leaf are from here to the end of the row.
inline BlockPainter::Side BlockPainter::side_of(uint32_t i) const noexcept {
  const Track& track = tracks_[i];
  const int32_t value = value_q22(track, track.row);
  if (value <= track.outside_q22) {
    return Side::outside;
  }
  return value >= track.inside_q22 ? Side::inside : Side::edge;
}

// A row of three fields: most of them matter in a part of their cell only.
__attribute__((noinline)) void BlockPainter::draw_three(const LeafFields& leaf,
                                                        PixelPlace place,
                                                        int32_t x,
                                                        int32_t end) noexcept {
  const Side a = side_of(0);
  if (a == Side::outside) {
    saturate(x, end, false);
    return;
  }
  const Side b = side_of(1);
  const Side c = side_of(2);
  // The one that does not matter, if any.
  uint32_t other = 3;
  if (leaf.is_nested) {
    if (b == Side::outside && c == Side::outside) {
      saturate(x, end, false);
      return;
    }
    if (b == Side::inside || c == Side::inside) {
      if (a == Side::inside) {
        saturate(x, end, true);
      } else {
        draw_single(tracks_[0], tracks_[0].row, x, end);
      }
      return;
    }
    if (b == Side::outside || c == Side::outside) {
      other = b == Side::outside ? 1 : 2;
    }
  } else if (b == Side::outside || c == Side::outside) {
    saturate(x, end, false);
    return;
  } else if (a == Side::inside || b == Side::inside || c == Side::inside) {
    other = a == Side::inside ? 0 : b == Side::inside ? 1 : 2;
  }
  if (other == 3) {
    draw_triple(leaf, place, x, end);
  } else {
    draw_pair(tracks_[other == 0 ? 1 : 0], tracks_[other == 2 ? 1 : 2], place,
              x, end);
  }
}

void BlockPainter::draw(LeafFields leaf, const Block& block) noexcept {
  const Side side = set_up_all(leaf, block);
  sign_ = leaf.sign;
  if (side != Side::edge) {
    if ((side == Side::inside) == (sign_ == 0)) {
      fill(block);
    }
    return;
  }
  pixels_per_slope_ = block.right - block.left > 4
                          ? (1u << 24) / static_cast<uint32_t>(slope_q14_)
                          : 0;
  const int32_t x = x0_ + block.left;
  const int32_t end = x0_ + block.right;
  PixelPlace place = place_of(block);
  for (int32_t row = block.top; row < block.bottom; ++row) {
    page_.writer.go_to_row(y0_ + row);
    if (leaf.count == 1) {
      draw_single(tracks_[0], tracks_[0].row, x, end);
    } else if (leaf.count == 2) {
      draw_pair(tracks_[0], tracks_[1], place, x, end);
    } else {
      draw_three(leaf, place, x, end);
    }
    page_.writer.flush();
    for (uint32_t i = 0; i < leaf.count; ++i) {
      tracks_[i].move_down();
    }
    place.y_q8 -= 1 << 8;
  }
}

}  // namespace detail
}  // namespace inkcell
