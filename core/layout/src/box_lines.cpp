#include "box_lines.hpp"

namespace inkcell::detail {
namespace {

int32_t height_of(const TextBox& box) noexcept {
  return (box.rect.y1 - box.rect.y0) * 64;
}

// With an ellipsis a box holds no more lines than it has room for.
size_t most_lines(const TextBox& box) noexcept {
  if (box.options.ellipsis == Ellipsis::none || !box.options.wraps) {
    return SIZE_MAX;
  }
  const int32_t height = line_step(box);
  const int32_t room = height_of(box);
  return height > 0 && room > height
             ? static_cast<uint32_t>(room) / static_cast<uint32_t>(height)
             : 1;
}

// Where the first of so many lines begins.
__attribute__((noinline)) int32_t top_of(const TextBox& box,
                                         size_t count) noexcept {
  const int32_t top = box.rect.y0 * 64;
  const int32_t height = line_step(box);
  const int64_t lines = static_cast<int64_t>(count) * height;
  int32_t room = height_of(box) -
                 (lines < kFarthest ? static_cast<int32_t>(lines) : kFarthest);
  if (box.vertical == VerticalAlign::bottom) {
    return top + room;
  }
  if (box.vertical == VerticalAlign::optical) {
    const Face& face = box.options.face;
    const int32_t rise = baseline(box.options).raw;
    const int32_t cap =
        to_px(*face.font, *face.style, face.font->metrics().cap_height).raw;
    // What is above capitals in the first line, and below the last baseline.
    room += (height - rise) - (rise - cap);
  }
  // Whole pixels, so that lines stay as sharp as at the top.
  return top + ((room / 2) & ~63);
}

}  // namespace

BoxLines::BoxLines(const TextBox& box,
                   const Painter& painter,
                   const Text& text,
                   const Span<const TextLine>& given) noexcept
    : box_(box), setting_{box.options, painter}, text_(text), given_(given) {
  box.options.forget();
  most_ = is_given() ? given.size : most_lines(box);
}

bool BoxLines::next() noexcept {
  if (count_ == most_) {
    return false;
  }
  if (is_given()) {
    line_ = given_[count_++];
    return true;
  }
  if (!detail::find_next_line(setting_, text_, box_width(box_), line_)) {
    return false;
  }
  ++count_;
  if (count_ == most_ && !line_.is_last) {
    detail::fill_line(setting_, text_, box_width(box_), line_);
    detail::shorten_line(setting_, text_, box_width(box_), line_);
  }
  return true;
}

int32_t BoxLines::top() noexcept {
  if (box_.vertical == VerticalAlign::top) {
    return box_.rect.y0 * 64;
  }
  if (!is_given()) {
    while (next()) {
    }
    line_ = {};
  }
  const size_t count = is_given() ? given_.size : count_;
  count_ = 0;
  return top_of(box_, count);
}

}  // namespace inkcell::detail
