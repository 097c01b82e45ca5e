// Which rectangles of the screen changed.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace kinetic {

/// The smallest rectangle around two; an empty one adds nothing.
Rect bounding_box(const Rect& a, const Rect& b) noexcept;

/// A few rectangles in the caller's memory that hold every one that was added.
/// Those that overlap, or together take hardly more than both, become one; so
/// do two if there is no room.
class DirtyRects {
 public:
  /// `room` must outlive it and hold at least one.
  constexpr explicit DirtyRects(Span<Rect> room) noexcept : room_(room) {}

  void clear() noexcept { count_ = 0; }
  /// Adds the part of `rect` that lies in `screen`.
  void add(const Rect& rect, const Rect& screen) noexcept;

  /// Disjoint. None: nothing changed.
  Span<const Rect> rects() const noexcept { return {room_.data, count_}; }

 private:
  void remove(size_t index) noexcept;

  Span<Rect> room_;
  size_t count_ = 0;
};

}  // namespace kinetic
}  // namespace inkcell
