// Fits heights: bars in zones first, then those between them.
#pragma once

#include <stdint.h>

#include "base/math.hpp"
#include "fit/fit_units.hpp"
#include "inkcell/fit.hpp"

namespace inkcell::detail {

// The least height of a bar where three of them have little room.
constexpr int32_t kLeastSqueezed = 32;
// Thicker bars begin at a row; thinner ones are centred in one.
constexpr int32_t kWholeBar = 60;

// `inline`, so that the compiler can drop functions that it inlines into their
// only caller.
class HeightFit {
 public:
  explicit HeightFit(const Fit& fit) noexcept : fit_(fit) {}

  __attribute__((noinline)) void read(GlyphHints& hints) noexcept {
    for (uint32_t i = hints.y_count(); i != 0; --i) {
      const YHint hint = hints.next_y();
      Item& item = *end_++;
      item.edges[0].at_u = static_cast<int16_t>(hint.low_u);
      item.edges[1].at_u = static_cast<int16_t>(hint.high_u);
      item.kind = hint.kind;
      item.is_top = hint.is_top;
      item.state = kFree;
      const int32_t width = item.is_bar() ? width_of(hint) : 0;
      int32_t to = 0;
      if (hint.zone < fit_.hints_.zone_count()) {
        const Fit::Zone& zone = fit_.zones_[hint.zone];
        to = hint.is_round ? zone.round_q6 : zone.flat_q6;
        if (hint.is_top) {
          to -= width;
        }
        item.state = kInZone;
      }
      // So far only the width of a free bar is known.
      item.set(to, width);
    }
    part_zones();
  }

  // Ends when all bars are fitted.
  __attribute__((noinline)) void fit_free() noexcept {
    for (Item* item = items_; item != end_; ++item) {
      if (item->is_bar() && item->state == kFree) {
        fit_bar(*item);
      }
    }
    for (Item* item = items_; item != end_; ++item) {
      if (item->kind == YHint::end) {
        fit_end(*item);
      }
    }
  }

  void write(AxisMap& map) const noexcept {
    for (const Item* item = items_; item != end_; ++item) {
      if (item->state == kFree) {
        continue;
      }
      fit_.add_knot(map, item->low().at_u, item->low().to);
      if (item->is_bar()) {
        fit_.add_knot(map, item->high().at_u, item->high().to);
      }
    }
  }

 private:
  enum State : uint8_t { kFree, kInZone, kFitted };

  struct Edge {
    int16_t at_u;
    // At most 40 px times the 4 em that a zone may be away, and what
    // part_zones() adds.
    int16_t to;
  };
  struct Item {
    Edge edges[2];
    YHint::Kind kind;
    State state;
    bool is_top;

    bool is_bar() const noexcept { return kind <= YHint::serif; }
    // Whether there is none of its ink above it; below it.
    bool has_ceiling() const noexcept { return is_bar() || is_top; }
    bool has_floor() const noexcept { return is_bar() || !is_top; }
    const Edge& low() const noexcept { return edges[0]; }
    const Edge& high() const noexcept { return edges[1]; }
    void set(int32_t to, int32_t width) noexcept {
      edges[0].to = static_cast<int16_t>(to);
      edges[1].to = static_cast<int16_t>(to + width);
    }
  };
  // The limit without a bar: more than twice as far away as edges can be apart.
  static constexpr int32_t kFar = 1 << 20;
  // As an edge, in words: the smallest cores load those in one instruction.
  struct Limit {
    int32_t at_u;  // unset where there is no bar
    int32_t to;
  };

  bool is_bilevel() const noexcept { return fit_.levels_ == 2; }

  int32_t width_of(const YHint& hint) const noexcept {
    const bool is_serif = hint.kind == YHint::serif;
    int32_t width = fit_.bar_q6_;
    if (is_serif || !hint.is_standard) {
      width = fit_.height_q6(hint.high_u) - fit_.height_q6(hint.low_u);
      if (is_serif) {
        return !is_bilevel() ? width : fit_.drops_serifs_ ? 0 : kPx;
      }
      width = common_width(width, fit_.bar_q6_);
    }
    return is_bilevel() ? whole_width(width) : max(width, kLeastStroke);
  }

  // The height as given by the zones above and below. [2 u]
  int32_t height_between(int32_t at_u2) const noexcept {
    const Edge* below = nullptr;
    const Edge* above = nullptr;
    for (const Item* item = items_; item != end_; ++item) {
      if (item->state != kInZone) {
        continue;
      }
      for (const Edge& edge : item->edges) {
        if (2 * edge.at_u <= at_u2) {
          below = below == nullptr || edge.at_u >= below->at_u ? &edge : below;
        } else {
          above = above == nullptr || edge.at_u < above->at_u ? &edge : above;
        }
      }
    }
    Edge near = {0, 0};  // without a zone, 0 is 0
    if (below != nullptr) {
      near = *below;
      if (above != nullptr) {
        return near.to +
               quotient((above->to - near.to) * (at_u2 - 2 * near.at_u),
                        2 * (above->at_u - near.at_u));
      }
    } else if (above != nullptr) {
      near = *above;
    }
    return ((at_u2 * fit_.y_scale_q16_ + (1 << 16)) >> 17) + near.to -
           fit_.height_q6(near.at_u);
  }

  // Zones are apart, but their rows need not be: keeps a row free between two
  // where the outline has 3/8 px, as between a stem and its dot. What is
  // below the baseline makes room downwards.
  void part_zones() noexcept {
    for (Item* item = items_ + 1; item < end_; ++item) {
      Item& below = item[-1];
      if (item->state != kInZone || below.state != kInZone ||
          !item->has_floor() || !below.has_ceiling()) {
        continue;
      }
      const int32_t open = fit_.px_q6(item->low().at_u - below.high().at_u);
      const int32_t least = !is_bilevel()        ? min(open, kLeastStroke)
                            : open < kPx * 3 / 8 ? 0
                                                 : kPx;
      const int32_t more = least - (item->low().to - below.high().to);
      if (more > 0) {
        Item& moved = below.high().at_u <= 0 ? below : *item;
        const int32_t width = moved.high().to - moved.low().to;
        moved.set(moved.low().to + (&moved == item ? more : -more), width);
      }
    }
  }

  // Bars that are not fitted yet set no limits.
  void find_room(const Item& item) noexcept {
    floor_.to = -kFar;
    ceiling_.to = kFar;
    for (const Item* other = items_; other != end_; ++other) {
      if (other->kind == YHint::end || other->state == kFree) {
        continue;
      }
      const Edge& low = other->low();
      const Edge& high = other->high();
      if (high.at_u <= item.low().at_u) {
        if (other->has_ceiling() && high.to > floor_.to) {
          floor_ = {high.at_u, high.to};
        }
      } else if (low.at_u >= item.high().at_u && other->has_floor() &&
                 low.to < ceiling_.to) {
        ceiling_ = {low.at_u, low.to};
      }
    }
  }

  // Puts a bar without a zone into the nearest rows that leave a free row on
  // both sides, as far as there is room.
  void fit_bar(Item& item) noexcept {
    find_room(item);
    const int32_t gap = is_bilevel() ? kPx : kLeastStroke;
    const int32_t floor = floor_.to;
    const int32_t ceiling = ceiling_.to;
    const int32_t left = ceiling - floor - 2 * gap;
    int32_t width = item.high().to - item.low().to;
    int32_t middle = height_between(item.low().at_u + item.high().at_u);
    if (left < width) {
      width = min(width, max(kLeastSqueezed, left));
      middle = (floor + ceiling) >> 1;
    }
    int32_t low;
    if (is_bilevel() || width >= kWholeBar) {
      width = is_bilevel() ? whole_width(width) : width;
      low = round_px(middle - (width >> 1));
      if (low < floor + gap && low + kPx + width <= ceiling) {
        low += kPx;
      }
      if (low + width > ceiling - gap && low - kPx >= floor) {
        low -= kPx;
      }
    } else {
      low = (middle & ~(kPx - 1)) + ((kPx - width) >> 1);
    }
    low = min(max(low, floor), ceiling - width);
    item.set(low, width);
    item.state = kFitted;
  }

  // Keeps a row open between a free end and the bar that it points to, but
  // moves it no farther than its own bar.
  void fit_end(Item& item) noexcept {
    find_room(item);
    const int32_t open = ceiling_.to - floor_.to;
    if (open >= kFar / 2) {
      return;
    }
    const int32_t whole_u = ceiling_.at_u - floor_.at_u;
    // Whether the map leaves less than a row.
    const int32_t open_u = item.is_top ? ceiling_.at_u - item.low().at_u
                                       : item.low().at_u - floor_.at_u;
    if (open * open_u < kPx * whole_u) {
      const int32_t kept = min(kPx, max(open, 0));
      item.set(item.is_top ? ceiling_.to - kept : floor_.to + kept, 0);
      item.state = kFitted;
    }
  }

  const Fit& fit_;
  // The limits given by the nearest bars above and below: find_room().
  Limit floor_;
  Limit ceiling_;
  Item* end_ = items_;
  Item items_[GlyphHints::kMostY];
};

}  // namespace inkcell::detail
