#include "field_sampler.hpp"

namespace inkcell {
namespace detail {

void FieldSampler::seek(const FieldPlace& at) noexcept {
  const GlyphField& field = tree_.field;
  const auto x = static_cast<uint64_t>(at.x_q16 - int64_t{field.x0_u} * 65536);
  const auto y = static_cast<uint64_t>(at.y_q16 - int64_t{field.y0_u} * 65536);
  const auto x_u = static_cast<uint32_t>(x >> 16);
  const auto y_u = static_cast<uint32_t>(y >> 16);
  const bool is_in_grid = (x | y) >> 32 == 0 && is_in_field(field, x_u, y_u);
  const bool is_kept =
      is_found_ && is_in_grid &&
      ((x_u ^ x_q16_ >> 16) | (y_u ^ y_q16_ >> 16)) >> leaf_.size_log2 == 0;
  x_q16_ = static_cast<uint32_t>(x);
  y_q16_ = static_cast<uint32_t>(y);
  if (!is_kept) {
    is_found_ = is_in_grid;
    leaf_ = {nullptr, 0, false};
    if (is_in_grid) {
      leaf_ = tree_.find(x_u, y_u);
    }
  }
}

int32_t FieldSampler::distance_q10(const FieldPlace& at) noexcept {
  seek(at);
  if (leaf_.samples == nullptr) {
    return leaf_.is_inside ? kSaturatedDistanceQ10 : -kSaturatedDistanceQ10;
  }
  return cell_row(leaf_.samples, leaf_.size_log2, y_in_leaf())
      .distance_q10(static_cast<int32_t>(x_in_leaf()));
}

Gradient FieldSampler::gradient(const FieldPlace& at) noexcept {
  seek(at);
  return leaf_.samples == nullptr
             ? Gradient()
             : cell_gradient(leaf_.samples, leaf_.size_log2, x_in_leaf(),
                             y_in_leaf());
}

FieldPoint FieldSampler::point(const FieldPlace& at) noexcept {
  seek(at);
  return leaf_.samples == nullptr ? FieldPoint()
                                  : cell_point(leaf_.samples, leaf_.size_log2,
                                               x_in_leaf(), y_in_leaf());
}

}  // namespace detail
}  // namespace inkcell
