// A soft edge that moves over a line.
#include "inkcell/motion/wipe.hpp"

#include "inkcell/motion/fade.hpp"
#include "inkcell/motion/numbers.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

// Edge and softness fit 16 bits. [px]
constexpr int32_t kFarthestEdge = 16384;

}  // namespace

void Wipe::set_edge(int32_t x0, int32_t x1, uint8_t soft) noexcept {
  x0_ = static_cast<int16_t>(clamp(x0, -kFarthestEdge, kFarthestEdge));
  x1_ = static_cast<int16_t>(clamp(x1, -kFarthestEdge, kFarthestEdge));
  soft_ = soft;
}

Rect Wipe::at(int32_t now_ms, const Painter& painter) noexcept {
  const int32_t last = edge_;
  if (last == INT16_MIN) {
    box_ = painter.box(*face_.font, *face_.style, origin_, text_);
    if (x0_ == x1_) {
      set_edge(
          box_.x0, box_.x1,
          static_cast<uint8_t>(clamp(face_.style->size().raw >> 7, 1, 255)));
    }
  }
  edge_ = static_cast<int16_t>(
      lerp(x0_, x1_ + soft_, ease(kEaseInOut, progress_at(timing_, now_ms))));
  if (last == INT16_MIN) {
    return box_;
  }
  return last == edge_ ? Rect()
                       : intersect(box_, {min(last, edge_) - soft_, box_.y0,
                                          max(last, edge_), box_.y1});
}

void Wipe::draw(const Painter& painter) const noexcept {
  SoftWindow soft;
  soft.target = &painter.sink();
  soft.window = box_;
  if (kind_ == Kind::reveal) {
    soft.window.x1 = edge_;
    soft.soft.right = soft_;
  } else {
    soft.window.x0 = edge_ - soft_;
    soft.soft.left = soft_;
  }
  const bool is_whole =
      kind_ == Kind::reveal ? edge_ >= box_.x1 + soft_ : edge_ <= box_.x0;
  const Sink sink = is_whole ? *soft.target : make_sink(soft);
  if (edge_ != INT16_MIN && !is_empty(sink.window)) {
    painter.with(sink).text(*face_.font, *face_.style, origin_, text_);
  }
}

}  // namespace inkcell::motion
