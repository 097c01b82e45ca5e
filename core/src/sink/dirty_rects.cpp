// A short list of disjoint rectangles.
#include "inkcell/dirty_rects.hpp"

namespace inkcell {
namespace {

int64_t area(const Rect& r) noexcept {
  return int64_t{r.x1 - r.x0} * (r.y1 - r.y0);
}

// Pixels of the bounding box that are in neither. Below 0 where they overlap a
// lot.
int64_t waste(const Rect& a, const Rect& b) noexcept {
  return area(bounding_box(a, b)) - area(a) - area(b);
}

}  // namespace

void DirtyRects::add(const Rect& rect, const Rect& screen) noexcept {
  Rect next = intersect(rect, screen);
  if (is_empty(next) || room_.size == 0) {
    return;
  }
  // Each round makes the list shorter or ends.
  for (;;) {
    size_t partner = count_;
    int64_t least = INT64_MAX;
    for (size_t i = 0; i < count_; ++i) {
      const int64_t wasted = is_empty(intersect(room_[i], next))
                                 ? waste(room_[i], next)
                                 : INT64_MIN;
      if (wasted < least) {
        least = wasted;
        partner = i;
      }
    }
    const bool is_cheap = least <= area(next) / 8;
    if (partner == count_ || (!is_cheap && count_ < room_.size)) {
      room_[count_++] = next;
      return;
    }
    next = bounding_box(room_[partner], next);
    room_[partner] = room_[--count_];
  }
}

}  // namespace inkcell
