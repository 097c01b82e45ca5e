#include "field_sampler.hpp"

#include "base/math.hpp"
#include "place/style_parts.hpp"

namespace inkcell::detail {
namespace {

// The length of a vector, which is that times 2^log2.
uint32_t length_of(int64_t x, int64_t y, int32_t& log2) noexcept {
  // Components of 15 bits, so that the sum of squares takes 32.
  constexpr int64_t kMost = (1 << 15) - 1;
  for (; x > kMost || x < -kMost || y > kMost || y < -kMost; ++log2) {
    x /= 2;
    y /= 2;
  }
  const auto square = [](int64_t value) noexcept {
    const auto side = static_cast<int32_t>(value);
    return static_cast<uint32_t>(side * side);
  };
  return root_of(square(x) + square(y));
}

}  // namespace

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

int32_t gain_q15(const Style& style, const Gradient& gradient) noexcept {
  const auto along = [&gradient](const GlyphStep& step) noexcept {
    return (int64_t{gradient.x.raw} * step.x_q20 +
            int64_t{gradient.y.raw} * step.y_q20) >>
           20;
  };
  int32_t own_log2 = 0;
  int32_t log2 = 0;
  const uint32_t own = length_of(gradient.x.raw, gradient.y.raw, own_log2)
                       << own_log2;
  const uint32_t shown =
      length_of(along(style.right()), along(style.up()), log2);
  if (shown == 0) {
    return 1 << 15;
  }
  const uint32_t gain = ((own << 15) / shown) >> log2;
  return max(min(static_cast<int32_t>(gain), 1 << 15),
             detail::StyleParts::least_gain_q15(style));
}

int32_t screen_distance_q10(const Style& style,
                            FieldSampler& sampler,
                            const FieldPlace& at) noexcept {
  if (!style.is_stretched()) {
    return style.to_px_q10(sampler.distance_q10(at));
  }
  const FieldPoint point = sampler.point(at);
  if (sampler.leaf().samples == nullptr) {
    return sampler.leaf().is_inside ? 32 << 10 : -(32 << 10);
  }
  return (style.to_px_q10(point.distance.raw) *
          gain_q15(style, point.gradient)) >>
         15;
}

}  // namespace inkcell::detail
