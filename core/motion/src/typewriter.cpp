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
  return {caret_x_, y - size * 3 / 4, caret_x_ + caret_width(),
          y + size / 5 + 1};
}

int32_t Typewriter::caret_width() const noexcept {
  return ((face_.style->size().raw >> 6) + 13) / 14;
}

// Calls `take` for each glyph of the text, from left to right. Not inline: a
// frame of its own.
template <typename Take>
__attribute__((noinline)) void Typewriter::walk(
    const Painter& painter,
    const Style& style,
    const Take& take) const noexcept {
  TextCursor cursor(painter, *face_.font, text_, style);
  PositionedGlyph glyph;
  while (cursor.next(glyph)) {
    take(glyph, cursor.letter());
  }
}

// The same with the style that the painter makes of its own.
template <typename Take>
void Typewriter::for_each(const Painter& painter,
                          const Take& take) const noexcept {
  Style room;
  walk(painter, painter.adapted(*face_.style, room), take);
}

Rect Typewriter::at(int32_t now_ms, const Painter& painter) noexcept {
  const size_t last = shown_;
  const Rect caret_before = is_caret_on_ ? caret() : Rect();
  const bool is_first = caret_x_ == INT32_MIN;
  const int32_t end = end_ms();
  Text hidden = text_;
  take_letters(hidden, now_ms < 0 ? 0 : now_ms / letter_ms_);
  shown_ = text_.size - hidden.size;
  is_caret_on_ = now_ms < end || (now_ms - end) / kBlinkMs % 2 == 0;
  if (!is_first && shown_ == last && is_caret_on_ != is_empty(caret_before)) {
    return {};
  }
  Rect changed;
  LetterEdges at;  // the letter whose end the caret is at
  size_t offset = 0;
  for_each(painter, [&](const PositionedGlyph& glyph, LetterEdges letter) {
    const bool is_shown = glyph.offset < shown_;
    if (is_shown != (glyph.offset < last)) {
      changed = bounding_box(changed, painter.box(*face_.font, *face_.style,
                                                  origin_, {&glyph, 1}));
    }
    if (is_shown && glyph.offset >= offset) {
      offset = glyph.offset;
      at = letter;
    } else if (shown_ == 0 && glyph.offset == 0) {
      at = letter;
      at.end = at.begin;
    }
  });
  const int32_t size = face_.style->size().raw;
  const int32_t x_q6 =
      origin_.x.raw + to_px(*face_.font, *face_.style, at.end).raw;
  caret_x_ = at.is_right_to_left
                 ? ((x_q6 - size / 16 + 32) >> 6) - caret_width()
                 : (x_q6 + size / 16 + 32) >> 6;
  const Rect caret_now = is_caret_on_ ? caret() : Rect();
  return bounding_box(changed, bounding_box(caret_before, caret_now));
}

void Typewriter::draw(const Painter& painter) const noexcept {
  for_each(painter, [&](const PositionedGlyph& glyph, LetterEdges) {
    if (glyph.offset < shown_) {
      painter.glyphs(*face_.font, *face_.style, origin_, {&glyph, 1});
    }
  });
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
