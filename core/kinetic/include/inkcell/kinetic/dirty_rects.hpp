// The rectangles of the screen that changed.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace kinetic {

/// The smallest rectangle that holds both; an empty one adds nothing.
Rect bounding_box(const Rect& a, const Rect& b) noexcept;

/// A short list of rectangles, in the caller's memory, that covers all that
/// were added. Two are merged if they overlap, if their bounding box is hardly
/// larger than both, or if there is no room.
class DirtyRects {
 public:
  /// `room` must outlive the list and hold at least one.
  constexpr explicit DirtyRects(Span<Rect> room) noexcept : room_(room) {}

  void clear() noexcept { count_ = 0; }
  /// Adds the part of `rect` that lies in `screen`.
  void add(const Rect& rect, const Rect& screen) noexcept;

  /// Disjoint rectangles; none if nothing changed.
  Span<const Rect> rects() const noexcept { return {room_.data, count_}; }

 private:
  Span<Rect> room_;
  size_t count_ = 0;
};

}  // namespace kinetic
}  // namespace inkcell
