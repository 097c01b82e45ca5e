// The text up to a letter, and a caret behind it.
#include "inkcell/motion/typewriter.hpp"

#include "inkcell/motion/timeline.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

// Takes up to so many letters off a text; returns how many.
int32_t take_letters(Text& text, int32_t most) noexcept {
  int32_t count = 0;
  for (; count < most && text.size != 0; ++count) {
    next_code_point(text);
  }
  return count;
}

}  // namespace

int32_t Typewriter::end_ms() const noexcept {
  Text text = text_;
  const int64_t end = int64_t{take_letters(text, INT32_MAX)} * letter_ms_;
  return static_cast<int32_t>(end < kNever ? end : kNever);
}

// From the ascenders to the descenders.
Rect Typewriter::caret() const noexcept {
  const int32_t size = face_.style->size().raw >> 6;
  const int32_t y = origin_.y.raw >> 6;
  return {caret_x_, y - size * 3 / 4, caret_x_ + (size + 13) / 14,
          y + size / 5 + 1};
}

Rect Typewriter::at(int32_t now_ms, const Painter& painter) noexcept {
  const size_t last = shown_;
  const Rect caret_before = is_caret_on_ ? caret() : Rect();
  const int32_t x_before = caret_x_;
  const bool is_first = x_before == INT32_MIN;
  const int32_t end = end_ms();
  Text hidden = text_;
  take_letters(hidden, now_ms < 0 ? 0 : now_ms / letter_ms_);
  shown_ = text_.size - hidden.size;
  is_caret_on_ = now_ms < end || (now_ms - end) / kBlinkMs % 2 == 0;
  const Q26_6 width =
      painter.measure(*face_.font, *face_.style, {text_.data, shown_}).advance;
  const int32_t size = face_.style->size().raw;
  caret_x_ = (origin_.x.raw + width.raw + size / 16 + 32) >> 6;
  const Rect caret_now = is_caret_on_ ? caret() : Rect();
  Rect changed;
  if (is_first || shown_ != last) {
    // Letters to the left of both carets stay, but for an overhang.
    changed = painter.box(*face_.font, *face_.style, origin_,
                          {text_.data, shown_ > last ? shown_ : last});
    if (!is_first) {
      const int32_t left = min(x_before, caret_x_) - (size >> 7);
      changed.x0 = max(changed.x0, left);
    }
  } else if (caret_before.x1 == caret_now.x1) {
    return {};
  }
  return bounding_box(changed, bounding_box(caret_before, caret_now));
}

void Typewriter::draw(const Painter& painter) const noexcept {
  painter.text(*face_.font, *face_.style, origin_, {text_.data, shown_});
  if (!is_caret_on_) {
    return;
  }
  const Sink& sink = painter.sink();
  const Rect box = intersect(caret(), sink.window);
  for (int32_t y = box.y0; y < box.y1 && box.x0 < box.x1; ++y) {
    sink.solid(sink.context, box.x0, y, box.x1 - box.x0);
  }
}

int32_t Typewriter::next_due(int32_t now_ms) const noexcept {
  const int32_t end = end_ms();
  const int32_t from = now_ms < end ? 0 : end;
  const int32_t step = now_ms < end ? letter_ms_ : kBlinkMs;
  const int64_t due = now_ms < 0
                          ? letter_ms_
                          : from + (int64_t{(now_ms - from) / step} + 1) * step;
  return static_cast<int32_t>(due < kNever ? due : kNever);
}

}  // namespace inkcell::motion
