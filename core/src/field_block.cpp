// A block's fields are set up once and then followed by addition, exact modulo
// 2^32, so that no pixel depends on where a window cuts the cell. What a
// field's slopes allow within the block tells how far from 0 it must be at the
// middle to leave all of it saturated; such fields are dropped or decide alone.
//
// Along a row most fields lead from outside through the ramp to inside, or
// back. Where the ramp begins is kept from row to row and moved by as many
// pixels as it takes, so that a row costs little more than the pixels on its
// ramps.
//
//        . . . . . . . 1 5 9 # # # # # #      1  where the ramp begins
//        . . . . . . 3 7 # # # # # # # #
//
// Values have the leaf's sign: there is only the least.
//
// What is not inline keeps the frames on the stack small.
#include "field_block.hpp"

#include "field_draw.hpp"
#include "order.hpp"

namespace inkcell {
namespace detail {
namespace {

// Half of it is more than what roundings of bent fields make, and the other
// half is how far a field that goes one way may go back. [px, Q22]
constexpr int32_t kArcMargin = 1 << 18;
constexpr int32_t kMaxDipQ14 = kArcMargin / 2 >> 8;

// From this width on fields are followed. [px]
constexpr int32_t kMinTracked = 5;

// From this width on a block is cut where a field turns, and one of three
// fields in the middle, so that most of them are left with fewer. [px]
constexpr int32_t kMinCut = 8;
constexpr int32_t kMinCutOfThree = 16;

// So many solid pixels are a run of their own, and so many empty ones a gap.
constexpr int32_t kMinSolid = 10;
constexpr int32_t kMinGap = 6;

// A sum that is from 0 to 256 px for all that keeps the format's limits. [px]
int32_t bounded(uint32_t value_q22) noexcept {
  constexpr int32_t kMost = 1 << 30;
  return greater(lesser(wrapped(value_q22), kMost), 0);
}

// Whether a field of this slope at the middle of a row goes back by more than a
// dip: its slope changes by `change_q14` to both sides. [px per px]
bool turns(int32_t change_q14, int32_t slope_q14, int32_t width) noexcept {
  const int32_t back_q14 = change_q14 - magnitude(slope_q14);
  if (back_q14 <= 0) {
    return false;
  }
  // The slope is on that side of 0 for back / (2 change) of the row.
  constexpr int32_t kSteep = 1 << 12;
  return back_q14 > kSteep || back_q14 * back_q14 * width >
                                  4 * kMaxDipQ14 * lesser(change_q14, 1 << 17);
}

}  // namespace

void BlockPainter::fill(const Rect& block) noexcept {
  for (int32_t y = block.y0; y < block.y1; ++y) {
    sink_.solid(sink_.context, block.x0, y, block.x1 - block.x0);
  }
}

// Sets a field up for the row above the block. What it shows of the block.
__attribute__((noinline)) BlockPainter::Side BlockPainter::set_up(
    Track& track, uint32_t unit, const PixelPlace& place) noexcept {
  namespace fields = format::fields;
  const uint8_t* at = field_.cells + 2 * (unit & format::linked::kOffsetMask);
  const int32_t nx_q14 = load_i16(at + fields::kNormalX);
  const int32_t ny_q14 = load_i16(at + fields::kNormalY);
  // From the middle to the outer pixels.
  int32_t half_x_q8 = (width_ - 1) << 7;
  const int32_t half_y_q8 = (height_ - 1) << 7;
  const uint32_t x_q8 = place.x_q8 + static_cast<uint32_t>(half_x_q8);
  const uint32_t y_q8 = place.y_q8 - static_cast<uint32_t>(half_y_q8);
  uint32_t plane_q22 = times(nx_q14, x_q8) + times(ny_q14, y_q8) +
                       times(load_i16(at + fields::kOffset), size_q8_);
  plane_q22 = static_cast<uint32_t>(with_sign(wrapped(plane_q22), sign_));
  int32_t value = wrapped(plane_q22);
  const int32_t dx_q14 = with_sign(nx_q14, sign_);
  const int32_t dy_q14 = with_sign(ny_q14, sign_);
  // The gradient at the middle, and how it changes on the way from there.
  int32_t slope_x_q14 = dx_q14;
  int32_t slope_y_q14 = dy_q14;
  int32_t change_q14 = 0;
  int32_t margin_q22 = 0;
  int32_t sag_q22 = 0;
  uint32_t along_q22 = 0;
  int32_t bend = 0;
  if ((unit & format::linked::kArcField) != 0) {
    along_q22 = times(nx_q14, y_q8) - times(ny_q14, x_q8) + (1 << 13) +
                times(load_i16(at + fields::kAlong), size_q8_);
    bend = (load_i16(at + fields::kBend) * bend_q14_ + (1 << 10)) >> 11;
    value = value_q22(bend, {plane_q22, along_q22});
    const auto slope =
        static_cast<uint32_t>(with_sign(slope_q15(bend, along_q22), sign_));
    slope_x_q14 -= wrapped(times(ny_q14, slope)) >> 14;
    slope_y_q14 += wrapped(times(nx_q14, slope)) >> 14;
    const auto way_q8 = static_cast<uint32_t>(
        (magnitude(nx_q14) * half_y_q8 + magnitude(ny_q14) * half_x_q8) >> 14);
    const auto change_q15 = static_cast<uint32_t>(
        wrapped(times(magnitude(bend), way_q8)) >> bend_shift_);
    margin_q22 = kArcMargin;
    sag_q22 = wrapped(change_q15 * way_q8) >> 1;
    change_q14 = wrapped(times(magnitude(ny_q14), change_q15)) >> 14;
  }
  const auto wide_q8 = static_cast<uint32_t>(half_x_q8);
  const auto high_q8 = static_cast<uint32_t>(half_y_q8);
  const int32_t reach_q22 = bounded(
      static_cast<uint32_t>(reach_q22_ + margin_q22) +
      static_cast<uint32_t>(sag_q22) + times(magnitude(slope_x_q14), wide_q8) +
      times(magnitude(slope_y_q14), high_q8));
  if (value >= reach_q22) {
    return Side::inside;
  }
  if (value <= -reach_q22) {
    return Side::outside;
  }
  track.bend = bend;
  track.unit = static_cast<uint16_t>(unit);
  track.rest = static_cast<int8_t>(width_ - 1);
  track.margin_q22 = margin_q22;
  track.is_left = false;
  track.is_wavy = false;
  // To the first pixel, a row above.
  int32_t step = 1 << 8;
  if (width_ < kMinTracked || turns(change_q14, slope_x_q14, width_)) {
    track.is_wavy = true;
    track.margin_q22 =
        bounded(static_cast<uint32_t>(margin_q22) +
                times(magnitude(slope_x_q14) + change_q14, 2 * wide_q8));
    if (width_ >= kMinCut) {
      // Where it turns.
      const int32_t way = slope_x_q14 * (width_ >> 1) / change_q14;
      cut_ = static_cast<uint8_t>((width_ >> 1) +
                                  ((bend ^ sign_) < 0 ? way : -way));
    }
  } else if (slope_x_q14 < 0) {
    track.is_left = true;
    step = -step;
    half_x_q8 = -half_x_q8;
  }
  const int32_t up_q8 = half_y_q8 + (1 << 8);
  track.spot.plane_q22 = plane_q22 -
                         times(dx_q14, static_cast<uint32_t>(half_x_q8)) +
                         times(dy_q14, static_cast<uint32_t>(up_q8));
  track.spot.along_q22 = along_q22 +
                         times(ny_q14, static_cast<uint32_t>(half_x_q8)) +
                         times(nx_q14, static_cast<uint32_t>(up_q8));
  track.further = {static_cast<uint32_t>(dx_q14 * step),
                   static_cast<uint32_t>(-ny_q14 * step)};
  track.down = {static_cast<uint32_t>(dy_q14 * (1 << 8)),
                static_cast<uint32_t>(nx_q14 * (1 << 8))};
  return Side::edge;
}

// Sets up the fields of a leaf and keeps those that matter. What the block
// shows.
inline BlockPainter::Side BlockPainter::set_up_all(
    const LeafFields& leaf, const PixelPlace& place) noexcept {
  sign_ = -(static_cast<int32_t>(leaf.op) & 1);
  is_nested_ = leaf.op >= FieldOperator::least_of_greater;
  count_ = leaf.count;
  for (uint32_t i = 0; i < count_; ++i) {
    tracks_[i].unit = leaf.units[i];
  }
  while (true) {
    const uint32_t all = count_;
    count_ = 0;
    Side sides[3];
    for (uint32_t i = 0; i < all; ++i) {
      sides[i] = set_up(tracks_[count_], tracks_[i].unit, place);
      if (sides[i] == Side::outside && (i == 0 || !is_nested_)) {
        return Side::outside;
      }
      if (sides[i] == Side::edge) {
        ++count_;
      }
    }
    if (!is_nested_ || count_ == 3) {
      break;
    }
    if (sides[1] == Side::outside && sides[2] == Side::outside) {
      return Side::outside;
    }
    is_nested_ = false;
    const bool is_first_left = sides[0] == Side::edge;
    if (sides[1] == Side::inside || sides[2] == Side::inside) {
      count_ = is_first_left ? 1 : 0;
      break;
    }
    if (is_first_left) {
      break;
    }
    // The greater of the others is all.
    sign_ = ~sign_;
  }
  return count_ == 0 ? Side::inside : Side::edge;
}

// Whether all rows of the block are alike.
inline bool BlockPainter::is_steady() const noexcept {
  for (uint32_t i = 0; i < count_; ++i) {
    if (tracks_[i].down.plane_q22 != 0 || tracks_[i].bend != 0) {
      return false;
    }
  }
  return true;
}

inline void BlockPainter::span(int32_t begin, int32_t end, int32_t y) noexcept {
  if (begin < end) {
    sink_.coverage(sink_.context, left_ + begin, y, buffer_ + begin,
                   end - begin);
  }
}

// Draws the rows of a lone field.
__attribute__((noinline)) void BlockPainter::draw_lone(int32_t y,
                                                       int32_t end_y) noexcept {
  const Track& track = tracks_[0];
  const int32_t bend = track.bend;
  const int32_t width = width_;
  const Spot further = track.further;
  const bool is_left = track.is_left;
  const bool is_wavy = track.is_wavy;
  const bool is_same = is_steady();
  const bool is_solid_left = is_left != (sign_ != 0);
  const int32_t outside_q22 = outside_q22_ - track.margin_q22;
  const int32_t inside_q22 = reach_q22_ + track.margin_q22;
  Spot spot = track.spot;
  int32_t most = width;  // pixels from `spot` on
  int32_t shown = 0;     // of them not outside: all or none
  int32_t full = 0;      // the last ones, which are inside
  for (bool is_drawn = false; y != end_y; ++y) {
    if (!is_drawn || !is_same) {
      is_drawn = true;
      spot = spot.minus(track.down);
      int32_t value = value_q22(bend, spot);
      full = 0;
      if (value > outside_q22) {
        for (; most != width; ++most) {
          const Spot back = spot.minus(further);
          const int32_t before = value_q22(bend, back);
          if (before <= outside_q22) {
            break;
          }
          spot = back;
          value = before;
        }
        full = most;
      } else if (!is_wavy) {
        while (most != 1) {
          --most;
          spot = spot.plus(further);
          value = value_q22(bend, spot);
          if (value > outside_q22) {
            full = most;
            break;
          }
        }
      }
      shown = full;
      if (full != 0 && value < inside_q22) {
        uint8_t* at = buffer_ + (is_left ? most - 1 : width - most);
        Spot next = spot;
        do {
          *at = coverage(value);
          at += is_left ? -1 : 1;
          next = next.plus(further);
          value = value_q22(bend, next);
        } while (--full != 0 && (is_wavy || value < inside_q22));
      }
    }
    // What is on the ramp, and what is full to one side of it.
    int32_t begin = is_left ? full : width - shown;
    int32_t end = is_left ? shown : width - full;
    const int32_t solid = is_solid_left ? begin : width - end;
    if (solid >= kMinSolid) {
      sink_.solid(sink_.context, left_ + (is_solid_left ? 0 : end), y, solid);
    } else if (solid != 0) {
      uint8_t* at = buffer_ + (is_solid_left ? 0 : end);
      for (uint8_t* const last = at + solid; at != last; ++at) {
        *at = 255;
      }
      begin = is_solid_left ? 0 : begin;
      end = is_solid_left ? end : width;
    }
    span(begin, end, y);
  }
}

// Pixels from `from` on are in the buffer, those from `begin` on are all full.
// Returns where what is in the buffer begins afterwards.
inline int32_t BlockPainter::solid(int32_t from,
                                   int32_t begin,
                                   int32_t end,
                                   int32_t y) noexcept {
  if (end - begin < kMinSolid) {
    for (; begin < end; ++begin) {
      buffer_[begin] = 255;
    }
    return from;
  }
  span(from, begin, y);
  sink_.solid(sink_.context, left_ + begin, y, end - begin);
  return end;
}

__attribute__((noinline)) void BlockPainter::hand_over(int32_t y) noexcept {
  int32_t from = row_.begin;
  int32_t end = row_.end;
  if (sign_ == 0) {
    from = solid(from, row_.solid_begin, row_.solid_end, y);
  } else {
    // All is the other way round.
    from = solid(0, 0, from, y);
    if (row_.solid_end - row_.solid_begin >= kMinGap) {
      span(from, row_.solid_begin, y);
      from = row_.solid_end;
    } else {
      for (int32_t x = row_.solid_begin; x < row_.solid_end; ++x) {
        buffer_[x] = 0;
      }
    }
    from = solid(from, end, width_, y);
    end = width_;
  }
  span(from, end, y);
}

BlockPainter::BlockPainter(const GlyphField& field,
                           const Brush& brush,
                           const Sink& sink) noexcept
    : field_(field),
      filter_(brush.filter()),
      sink_(sink),
      size_q8_(scale_of(brush).size_q8),
      bend_q14_(brush.bend_q14()),
      reach_q22_(reach_of(filter_)),
      ramp_({filter_.outside_q10,
             static_cast<uint16_t>(
                 greater(filter_.inside_q10 - filter_.outside_q10, 0)),
             filter_.scale}),
      bend_shift_(static_cast<uint8_t>(brush.bend_log2() + 5)) {}

inline void BlockPainter::next_row() noexcept {
  const uint32_t some = follow_all();
  switch (some) {
    case 0:
      row_ = row(0, 0, width_, width_);
      break;
    case 1:
    case 2:
    case 4:
      single_row(tracks_[some >> 1]);
      break;
    case kAll:
      triple_row();
      break;
    case kNone:
      set_outside();
      break;
    default:  // two of three
      pair_row(tracks_[~some & 1], tracks_[1 + (some >> 2)]);
  }
}

void BlockPainter::draw(const LeafFields& leaf, Rect& block) noexcept {
  left_ = block.x0;
  height_ = static_cast<uint8_t>(block.y1 - block.y0);
  const PixelPlace place = {
      origin_.x_q8 + (static_cast<uint32_t>(block.x0) << 8),
      origin_.y_q8 - (static_cast<uint32_t>(block.y0) << 8)};
  while (true) {
    cut_ = 0;
    width_ = block.x1 - block.x0;
    const Side side = set_up_all(leaf, place);
    if (side != Side::edge) {
      if ((side == Side::inside) == (sign_ == 0)) {
        fill(block);
      }
      return;
    }
    if (count_ == 3 && width_ >= kMinCutOfThree) {
      cut_ = static_cast<uint8_t>(width_ >> 1);
    }
    if (cut_ <= 1 || cut_ >= width_ - 1) {
      break;
    }
    block.x1 = block.x0 + cut_;
  }
  if (is_nested_) {
    // What is below the ramp may still round the greater of two.
    outside_q22_ = -reach_q22_;
  } else {
    outside_q22_ = sign_ == 0 ? (filter_.outside_q10 + 1) * (1 << 12) - 1
                              : -filter_.inside_q10 * (1 << 12);
  }
  const int32_t end = block.y1;
  int32_t y = block.y0;
  if (count_ == 1) {
    draw_lone(y, end);
    return;
  }
  const bool is_same = is_steady();
  for (bool is_drawn = false; y != end; ++y) {
    if (!is_drawn || !is_same) {
      is_drawn = true;
      next_row();
    }
    hand_over(y);
  }
}

}  // namespace detail
}  // namespace inkcell
