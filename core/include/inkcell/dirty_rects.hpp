// The rectangles of the screen that changed.
//
//   Rect room[4];
//   DirtyRects dirty(room);
//   dirty.add(before, screen);
//   dirty.add(after, screen);
//   for (const Rect& rect : dirty.rects()) {
//     INKCELL_TRY(port::run_strips(loop, rect));
//   }
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/geometry.hpp"
#include "inkcell/span.hpp"

namespace inkcell {

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

}  // namespace inkcell
