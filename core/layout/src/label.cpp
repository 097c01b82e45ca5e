#include "inkcell/layout/label.hpp"

#include "next_line.hpp"
#include "pen.hpp"

namespace inkcell {
namespace {

// In shaped text marks stand farther to the left than what is before them. By
// so many em at most; where a font says more, they may be cut at the window.
constexpr int32_t kMarkReach = 2;

// How far ink of a face reaches from a glyph's origin, at most. [units of the
// first face]
int32_t reach_of(const Face& first, const Face& face) noexcept {
  const FontMetrics metrics = face.font->metrics();
  const int32_t right = metrics.x_max;
  const int32_t left = -metrics.x_min;
  const int64_t units = right > left ? right : left;
  const int64_t scaled =
      units * face.style->size().raw * first.font->units_per_em() /
      (int64_t{first.style->size().raw} * face.font->units_per_em());
  return scaled < detail::kMaxUnits ? static_cast<int32_t>(scaled) + 1
                                    : detail::kMaxUnits;
}

}  // namespace

Status ScrollingLabel::make(const LayoutOptions& options,
                            const Painter& painter,
                            Text text,
                            const Rect& window,
                            Span<PositionedGlyph> room,
                            ScrollingLabel& out) noexcept {
  if (text.size > kMaxLineBytes) {
    return Status::bad_argument;
  }
  const detail::Setting setting = {options, painter};
  const TextLine line = detail::first_line(setting, text);
  Span<const PositionedGlyph> glyphs;
  INKCELL_TRY(detail::lay_out_in(setting, text, line, nullptr, room, glyphs));
  out.face_ = options.face;
  out.fallback_ = options.fallback;
  out.glyphs_ = glyphs;
  out.window_ = window;
  const int32_t free_q6 =
      (window.y1 - window.y0) * 64 - line_height(options).raw;
  out.baseline_ = Q26_6::from_raw(window.y0 * 64 + ((free_q6 / 2) & ~63) +
                                  baseline(options).raw);
  out.width_ = line.width;
  out.reach_ = reach_of(options.face, options.face);
  for (const Face& face : options.fallback) {
    const int32_t reach = reach_of(options.face, face);
    out.reach_ = reach > out.reach_ ? reach : out.reach_;
  }
  if (options.shaper() != nullptr) {
    out.reach_ += kMarkReach * options.face.font->units_per_em();
  }
  return Status::ok;
}

Q26_6 ScrollingLabel::width() const noexcept {
  return face_.font == nullptr ? Q26_6{}
                               : to_px(*face_.font, *face_.style, width_);
}

bool ScrollingLabel::needs_scrolling() const noexcept {
  return width().raw > (window_.x1 - window_.x0) * 64;
}

// The first glyph whose origin is at `x` or to the right of it.
size_t ScrollingLabel::first_from(int32_t x) const noexcept {
  size_t begin = 0;
  size_t end = glyphs_.size;
  while (begin < end) {
    const size_t middle = begin + (end - begin) / 2;
    if (glyphs_[middle].x < x) {
      begin = middle + 1;
    } else {
      end = middle;
    }
  }
  return begin;
}

void ScrollingLabel::draw(Q26_6 scroll, const Painter& painter) const noexcept {
  const bool is_still = scroll.raw == 0 && !needs_scrolling();
  draw_in(is_still ? painter.sink().window : window_, scroll, painter);
}

void ScrollingLabel::draw_in(const Rect& clip,
                             Q26_6 scroll,
                             const Painter& painter) const noexcept {
  if (face_.font == nullptr) {
    return;
  }
  constexpr int32_t kFar = 1 << 28;
  scroll.raw = detail::clamp_to(scroll.raw, kFar);
  Sink clipped = painter.sink();
  clipped.window = intersect(clipped.window, clip);
  const int32_t left_px = (clipped.window.x0 - window_.x0) * 64 + scroll.raw;
  const int32_t right_px = (clipped.window.x1 - window_.x0) * 64 + scroll.raw;
  if (is_empty(clipped.window)) {
    return;
  }
  // Filters and effects reach a few pixels farther than ink.
  constexpr int32_t kBeyond = 8 * 64;
  const auto units = [this](int32_t px_q6) noexcept {
    return detail::clamp_to(
        int64_t{px_q6} * face_.font->units_per_em() / face_.style->size().raw,
        kFar);
  };
  const size_t first = first_from(units(left_px - kBeyond) - reach_);
  const size_t end = first_from(units(right_px + kBeyond) + reach_);
  painter.with(clipped).glyphs(
      face_, fallback_,
      {Q26_6::from_raw(window_.x0 * 64 - scroll.raw), baseline_},
      {glyphs_.data + first, end - first});
}

void ScrollingLabel::draw_endless(Q26_6 scroll,
                                  Q26_6 gap,
                                  const Painter& painter) const noexcept {
  const int32_t period = width().raw + gap.raw;
  if (period <= 0) {
    return;
  }
  int32_t at = scroll.raw % period;
  at = at < 0 ? at + period : at;
  const int32_t room = (window_.x1 - window_.x0) * 64;
  for (; - at < room; at -= period) {
    draw_in(window_, Q26_6::from_raw(at), painter);
  }
}

}  // namespace inkcell
