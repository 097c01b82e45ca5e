// Each minute begins with the change: the last digit first, then the others.
#include "clock_scene.hpp"

#include "inkcell/kinetic/easing.hpp"
#include "inkcell/kinetic/run.hpp"
#include "inkcell/kinetic/timeline.hpp"
#include "inkcell/painter.hpp"

namespace inkcell {
namespace scenes {
namespace {

using namespace kinetic;

constexpr uint32_t kBackground = 0x0b0f16;
constexpr uint32_t kInk = 0xffd9a0;
constexpr uint32_t kHotInk = 0xffffff;
constexpr uint32_t kGlow = 0xa8501a;
constexpr uint32_t kColonInk = 0xff8f3c;
constexpr uint32_t kMinutesPerDay = 24 * 60;

constexpr int32_t kChangeMs = 620;
constexpr int32_t kStepMs = 110;  // from digit to digit
constexpr Easing kChange = cubic_bezier(650, 0, 350, 1000);

// The glow around digits of large screens.
constexpr Filter kGlowFilter =
    make_filter({Q6_10::from_raw(-4096), Q6_10::from_raw(1024),
                 Fixed<uint16_t, 8>::from_int(2)});
constexpr int32_t kGlowFromPx = 60;

// Takes one or two digits off a text.
bool read_number(Text& text, size_t least, uint32_t& out) noexcept {
  out = 0;
  size_t count = 0;
  while (count < 2 && text.size != 0 && *text.data >= '0' &&
         *text.data <= '9') {
    out = out * 10 + static_cast<uint32_t>(*text.data - '0');
    text = {text.data + 1, text.size - 1};
    ++count;
  }
  return count >= least;
}

bool read_time(Text text, uint32_t& minute) noexcept {
  uint32_t hour;
  if (!read_number(text, 1, hour) || text.size == 0 || *text.data != ':') {
    return false;
  }
  text = {text.data + 1, text.size - 1};
  if (!read_number(text, 2, minute) || text.size != 0 || hour > 23 ||
      minute > 59) {
    return false;
  }
  minute += hour * 60;
  return true;
}

}  // namespace

Span<int8_t> ClockScene::part_of(Span<int8_t> grids,
                                 int32_t digit) const noexcept {
  const size_t bytes = morph_bytes(layout_.box);
  const size_t first = bytes * static_cast<size_t>(digit);
  return first + bytes <= grids.size ? Span<int8_t>(grids.data + first, bytes)
                                     : Span<int8_t>();
}

ClockScene::ClockScene(const SceneSetting& setting) noexcept
    : font_(*setting.font),
      text_(setting.text),
      width_(setting.width),
      height_(setting.height),
      layout_(layout_of(width_, height_)),
      workspace_(setting.workspace),
      digits_{
          {font_, Q26_6::from_int(layout_.size_px), kFilterMotion, layout_.box,
           part_of(setting.memory.grid, 0), setting.workspace},
          {font_, Q26_6::from_int(layout_.size_px), kFilterMotion, layout_.box,
           part_of(setting.memory.grid, 1), setting.workspace},
          {font_, Q26_6::from_int(layout_.size_px), kFilterMotion, layout_.box,
           part_of(setting.memory.grid, 2), setting.workspace},
          {font_, Q26_6::from_int(layout_.size_px), kFilterMotion, layout_.box,
           part_of(setting.memory.grid, 3), setting.workspace}} {}

Status ClockScene::open() noexcept {
  if (!read_time(text_, first_minute_)) {
    return Status::bad_argument;
  }
  for (uint32_t i = 0; i < 10; ++i) {
    digit_glyphs_[i] = font_.glyph_or_notdef('0' + i);
  }
  colon_ = font_.glyph_or_notdef(':');
  for (int32_t i = 0; i < kDigits; ++i) {
    const uint16_t glyph = digit_glyphs_[digit_of(first_minute_, i)];
    INKCELL_TRY(digits_[i].set(glyph, glyph));
    from_[i] = to_[i] = glyph;
    progress_[i] = Q16_16();
  }
  set_frame(0);
  return Status::ok;
}

uint32_t ClockScene::digit_of(uint32_t minute, int32_t digit) const noexcept {
  minute %= kMinutesPerDay;
  switch (digit) {
    case 0:
      return minute / 600;
    case 1:
      return minute / 60 % 10;
    case 2:
      return minute / 10 % 6;
    default:
      return minute % 10;
  }
}

void ClockScene::set_frame(uint32_t frame) noexcept {
  frame_ = frame;
  const uint32_t passed = frame / kFramesPerMinute;
  const auto time_ms =
      static_cast<int32_t>(frame % kFramesPerMinute) * 1000 / kFramesPerSecond;
  const uint32_t now = first_minute_ + passed;
  for (int32_t i = 0; i < kDigits; ++i) {
    // The first minute has no predecessor.
    const uint32_t before = passed == 0 ? now : now + kMinutesPerDay - 1;
    const uint16_t from = digit_glyphs_[digit_of(before, i)];
    const uint16_t to = digit_glyphs_[digit_of(now, i)];
    const int32_t begin = (kDigits - 1 - i) * kStepMs;
    const Q16_16 progress =
        ease(kChange, fraction(begin, begin + kChangeMs, time_ms));
    const Q16_16 last = progress_[i];
    const uint16_t shown = last.raw == 0 ? from_[i] : to_[i];
    const bool was_still = last.raw == 0 || last.raw == 1 << 16;
    if (from_[i] != from || to_[i] != to) {
      set_digit(i, from, to);
    }
    progress_[i] = from == to ? Q16_16::from_int(1) : progress;
    if (!has_outlines_[i]) {
      digits_[i].step(progress_[i], scratch_);
    }
    const bool is_still =
        from == to || progress.raw == 0 || progress.raw == 1 << 16;
    const uint16_t shows = from == to || progress.raw != 0 ? to : from;
    has_changed_[i] = !(was_still && is_still && shown == shows);
  }
}

void ClockScene::set_digit(int32_t digit, uint16_t from, uint16_t to) noexcept {
  from_[digit] = from;
  to_[digit] = to;
  has_outlines_[digit] =
      from != to &&
      OutlineMorph::open(font_, from, to, outlines_[digit]) == Status::ok &&
      OutlineMorph::workspace_bytes(font_) <= workspace_.size;
  if (!has_outlines_[digit]) {
    // They fit: open() has tried it.
    static_cast<void>(digits_[digit].set(from, to));
  }
}

Rect ClockScene::box_of(int32_t digit) const noexcept {
  const int32_t x = layout_.left + digit * layout_.digit_px +
                    (digit >= 2 ? layout_.colon_px : 0);
  return {x, layout_.top, x + layout_.box.width,
          layout_.top + layout_.box.height};
}

// Where a digit on its way has its origin: glyphs are centred by their advance.
Point ClockScene::origin_of(int32_t digit) const noexcept {
  const Rect box = box_of(digit);
  const Q26_6 size = Q26_6::from_int(layout_.size_px);
  const auto advance_q6 = [&](uint16_t glyph) {
    return to_px_q16(font_, size, font_.advance(glyph)).raw >> 10;
  };
  const int32_t before = advance_q6(from_[digit]);
  const int32_t after = advance_q6(to_[digit]);
  const auto middle = static_cast<int32_t>(
      before + (int64_t{after - before} * progress_[digit].raw >> 16));
  return {Q26_6::from_raw(box.x0 * 64 + (layout_.box.width * 64 - middle) / 2),
          Q26_6::from_int(box.y0 + layout_.box.baseline)};
}

void ClockScene::draw_digit(int32_t digit,
                            const Filter& filter,
                            const Sink& sink) const noexcept {
  const Rect box = box_of(digit);
  if (!has_outlines_[digit]) {
    digits_[digit].draw(box.x0, box.y0, filter, sink);
    return;
  }
  Sink clipped = sink;
  clipped.window = intersect(sink.window, box);
  if (!is_empty(clipped.window)) {
    outlines_[digit].draw(Painter(clipped, workspace_),
                          Style(Q26_6::from_int(layout_.size_px), filter),
                          origin_of(digit), progress_[digit]);
  }
}

void ClockScene::draw_colon(const Paper& paper) const noexcept {
  const Q26_6 size = Q26_6::from_int(layout_.size_px);
  const Style style(size, kFilterMotion);
  const int32_t advance_q6 = static_cast<int32_t>(
      int64_t{font_.advance(colon_)} * size.raw / font_.units_per_em());
  const int32_t left_q6 = (layout_.left + 2 * layout_.digit_px) * 64;
  const int32_t x_q6 = left_q6 + (layout_.colon_px * 64 - advance_q6) / 2;
  // A little above the baseline: the middle of the digits.
  const int32_t y = layout_.top + layout_.box.baseline - layout_.size_px / 11;
  Painter(paper.with(kColonInk), workspace_)
      .glyph(font_, style, {Q26_6::from_raw(x_q6), Q26_6::from_int(y)}, colon_);
}

void ClockScene::draw(const Paper& paper) noexcept {
  paper.fill(kBackground);
  draw_colon(paper);
  for (int32_t i = 0; i < kDigits; ++i) {
    // Hot at half the progress.
    const int32_t part = progress_[i].raw;
    const int32_t heat =
        static_cast<int32_t>(int64_t{part} * (65536 - part) >> 22);  // to 256
    if (heat > 0 && layout_.size_px >= kGlowFromPx) {
      draw_digit(i, kGlowFilter, paper.with(mix_rgb(kBackground, kGlow, heat)));
    }
    draw_digit(i, kFilterMotion, paper.with(mix_rgb(kInk, kHotInk, heat)));
  }
}

void ClockScene::add_changes(DirtyRects& dirty) const noexcept {
  for (int32_t i = 0; i < kDigits; ++i) {
    if (has_changed_[i]) {
      dirty.add(box_of(i), {0, 0, width_, height_});
    }
  }
}

uint32_t ClockScene::next_due() const noexcept {
  constexpr int32_t kEndMs = kChangeMs + (kDigits - 1) * kStepMs;
  constexpr uint32_t kEndFrame = kEndMs * kFramesPerSecond / 1000 + 1;
  const uint32_t in_minute = frame_ % kFramesPerMinute;
  const bool rests = frame_ < kFramesPerMinute || in_minute >= kEndFrame;
  return frame_ + (rests ? kFramesPerMinute - in_minute : 1);
}

void ClockScene::tell_state(const StateSink& sink) const noexcept {
  for (int32_t i = 0; i < kDigits; ++i) {
    sink.tell(from_[i]);
    sink.tell(to_[i]);
    sink.tell(progress_[i].raw);
    sink.tell(has_outlines_[i] ? 0 : digits_[i].cutoff().raw);
  }
}

}  // namespace scenes
}  // namespace inkcell
