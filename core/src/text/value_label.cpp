#include "inkcell/value_label.hpp"

namespace inkcell {

Point ValueLabel::place(const Painter& painter) const noexcept {
  Point place = origin_;
  if (anchor_ != Anchor::left && style_->is_upright()) {
    const int32_t width = painter.measure(*font_, *style_, text()).advance.raw;
    place.x.raw -= anchor_ == Anchor::right ? width : width / 2;
  }
  return place;
}

Rect ValueLabel::set(Text text, const Painter& painter) noexcept {
  const size_t size = text.size;
  text = cut(text, kMostBytes);
  if (text.size != size && painter.report() != nullptr) {
    painter.report()->note(Status::cut);
  }
  if (text.size == size_ && __builtin_memcmp(text.data, bytes_, size_) == 0) {
    return {};
  }
  __builtin_memcpy(bytes_, text.data, text.size);
  size_ = static_cast<uint8_t>(text.size);
  const Rect before = box_;
  box_ = painter.box(*font_, *style_, place(painter), this->text());
  return bounding_box(before, box_);
}

void ValueLabel::draw(const Painter& painter) const noexcept {
  if (!is_empty(intersect(box_, painter.sink().window))) {
    painter.text(*font_, *style_, place(painter), text());
  }
}

}  // namespace inkcell
