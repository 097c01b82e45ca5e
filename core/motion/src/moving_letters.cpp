// A pose for each letter, made when it is drawn.
#include "inkcell/motion/moving_letters.hpp"

#include "limits.hpp"

namespace inkcell::motion {

PosedGlyph MovingLetters::posed(size_t index, int32_t now_ms) const noexcept {
  constexpr int32_t kMostMs = 1 << 30;
  const int64_t time =
      int64_t{now_ms} - delay_of(motion_.stagger,
                                 unit_of(run_, Unit::glyph, index),
                                 unit_count(run_, Unit::glyph));
  return place(
      font_, run_, index, where_,
      pose_at(motion_.keys,
              local_time(motion_.timing, clamp_i64(time, -kMostMs, kMostMs))));
}

Rect MovingLetters::at(int32_t now_ms) noexcept {
  const int32_t last_ms = now_ms_;
  now_ms_ = now_ms;
  Rect changed;
  for (size_t i = 0; i < run_.glyphs.size; ++i) {
    const PosedGlyph now = posed(i, now_ms);
    const PosedGlyph last = posed(i, last_ms);
    if (!is_drawn_ || now != last) {
      changed = bounding_box(changed, renderer_.box(now));
      if (is_drawn_) {
        changed = bounding_box(changed, renderer_.box(last));
      }
    }
  }
  is_drawn_ = true;
  return changed;
}

void MovingLetters::draw(const Painter& painter) noexcept {
  for (size_t i = 0; i < run_.glyphs.size; ++i) {
    const PosedGlyph now = posed(i, now_ms_);
    renderer_.draw({&now, 1}, painter);
  }
}

}  // namespace inkcell::motion
