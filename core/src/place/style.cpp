// Sizes, directions and matrices as the numbers that drawing needs.
#include "inkcell/style.hpp"

namespace inkcell {
namespace {

// The length of a vector, rounded down; components below 2^30.
int64_t length_of(int64_t x, int64_t y) noexcept {
  auto rest = static_cast<uint64_t>(x * x + y * y);
  uint64_t root = 0;
  for (uint64_t bit = uint64_t{1} << 60; bit != 0; bit >>= 2) {
    const uint64_t sum = root + bit;
    root >>= 1;
    if (rest >= sum) {
      rest -= sum;
      root += bit;
    }
  }
  return static_cast<int64_t>(root);
}

// An entry of a matrix over the size. [px, Q16 -> Q30]
Fixed<int32_t, 30> over_size(Q16_16 entry_px, int32_t size_q6) noexcept {
  return Fixed<int32_t, 30>::from_raw(
      static_cast<int32_t>(int64_t{entry_px.raw} * (1 << 20) / size_q6));
}

// What a row of a matrix's inverse is as a step: entries over the determinant,
// at most 256.
GlyphStep step_from(int32_t x_q30,
                    int32_t y_q30,
                    int64_t determinant_q42,
                    int32_t size_q6) noexcept {
  constexpr int64_t kScale = int64_t{1} << 32;
  const int64_t x_q20 = x_q30 * kScale / determinant_q42;
  const int64_t y_q20 = y_q30 * kScale / determinant_q42;
  // 1024 u over size/64 px: 2^10 2^6 2^-4 / size.
  return {static_cast<int32_t>(x_q20 * (1 << 12) / size_q6),
          static_cast<int32_t>(y_q20 * (1 << 12) / size_q6),
          static_cast<int32_t>(x_q20), static_cast<int32_t>(y_q20)};
}

}  // namespace

// Greatest and least. [px/em, Q6]
struct Style::Stretch {
  int32_t most_q6;
  int32_t least_q6;
};

// Makes it upright, but for what `least_q6` changes. Untouched if it fails.
Status Style::set_size(const Stretch& stretch, const Filter& filter) noexcept {
  if (stretch.least_q6 < kMinSize.raw || stretch.most_q6 > kMaxSize.raw) {
    return Status::bad_argument;
  }
  const auto size_q6 = static_cast<uint32_t>(stretch.most_q6);
  // Smaller than to assign a Style: nearly all of it is 0 or follows here.
  __builtin_memset(static_cast<void*>(this), 0, sizeof *this);
  right_.x_q20 = 1 << 20;
  up_.y_q20 = 1 << 20;
  axes_.x_right.raw = 1 << 30;
  axes_.y_up.raw = 1 << 30;
  least_gain_q15_ = 1 << 15;
  filter_ = &filter;
  size_q6_ = stretch.most_q6;
  // All else takes 2^32 over the size. [Q32] Of a power of two that is one more
  // than what 32 bits make of it.
  uint32_t over_q32 = UINT32_MAX / size_q6;
  limit_u_q10_ = static_cast<int32_t>(over_q32 >> 1);
  over_q32 += (size_q6 & (size_q6 - 1)) == 0 ? 1 : 0;
  // u to the px. 1024 u over size/64 px: 2^10 2^6 2^16 / size. [Q16]
  right_.x_q16 = static_cast<int32_t>(over_q32);
  up_.y_q16 = right_.x_q16;
  return Status::ok;
}

Status Style::make_upright(Q26_6 size,
                           const Filter& filter,
                           Style& out) noexcept {
  return out.set_size({size.raw, size.raw}, filter);
}

Status Style::make_turned(Q26_6 size,
                          const Filter& filter,
                          Direction direction,
                          Style& out) noexcept {
  const int64_t cosine = direction.cosine.raw;
  const int64_t sine = direction.sine.raw;
  constexpr int64_t kOneQ30 = int64_t{1} << 30;
  const int64_t length_squared =
      ((cosine >> 1) * (cosine >> 1) + (sine >> 1) * (sine >> 1)) >> 28;
  const int64_t excess = length_squared - kOneQ30;
  if (excess > kOneQ30 / 500 || excess < -kOneQ30 / 500) {
    return Status::bad_argument;
  }
  INKCELL_TRY(make_upright(size, filter, out));
  if (sine != 0 || cosine < 0) {
    const int64_t step_q16 = out.step_along_q16();
    const auto along = static_cast<int32_t>((step_q16 * cosine) >> 30);
    const auto across = static_cast<int32_t>((step_q16 * sine) >> 30);
    const int32_t along_px = direction.cosine.raw >> 10;
    const int32_t across_px = direction.sine.raw >> 10;
    out.right_ = {along, -across, along_px, -across_px};
    out.up_ = {across, along, across_px, along_px};
    out.axes_ = {direction.cosine, direction.sine,
                 Fixed<int32_t, 30>::from_raw(-direction.sine.raw),
                 direction.cosine};
    out.set_slanted();
  }
  return Status::ok;
}

Status Style::make_mapped(const Matrix& matrix,
                          const Filter& filter,
                          Style& out) noexcept {
  const int64_t x_right = matrix.x_right.raw;
  const int64_t x_up = matrix.x_up.raw;
  const int64_t y_right = matrix.y_right.raw;
  const int64_t y_up = matrix.y_up.raw;
  constexpr int64_t kLimit = int64_t{kMaxSize.raw} << 11;
  const int64_t entries[] = {x_right, x_up, y_right, y_up};
  for (const int64_t entry : entries) {
    if (entry > kLimit || entry < -kLimit) {
      return Status::bad_argument;
    }
  }
  // A matrix is the sum of a turn and a mirrored turn, each times a number; its
  // greatest and least stretch are sum and difference of the two.
  const int64_t turn_q17 = length_of(x_right + y_up, x_up - y_right);
  const int64_t mirror_q17 = length_of(x_right - y_up, x_up + y_right);
  const int64_t least_q17 =
      turn_q17 < mirror_q17 ? mirror_q17 - turn_q17 : turn_q17 - mirror_q17;
  const Stretch stretch = {
      static_cast<int32_t>((turn_q17 + mirror_q17 + (1 << 10)) >> 11),
      static_cast<int32_t>((least_q17 + (1 << 10)) >> 11)};
  const int32_t size_q6 = stretch.most_q6;
  INKCELL_TRY(out.set_size(stretch, filter));
  if (mirror_q17 == 0 && x_up == 0 && x_right == int64_t{size_q6} << 10) {
    return Status::ok;  // upright
  }
  Axes& axes = out.axes_;
  axes = {over_size(matrix.x_right, size_q6), over_size(matrix.x_up, size_q6),
          over_size(matrix.y_right, size_q6), over_size(matrix.y_up, size_q6)};
  const int64_t determinant_q60 = int64_t{axes.x_right.raw} * axes.y_up.raw -
                                  int64_t{axes.x_up.raw} * axes.y_right.raw;
  // At least 1/256, in Q42.
  const int64_t determinant_q42 = determinant_q60 / (1 << 18);
  out.right_ =
      step_from(axes.y_up.raw, -axes.x_up.raw, determinant_q42, size_q6);
  out.up_ =
      step_from(-axes.y_right.raw, axes.x_right.raw, determinant_q42, size_q6);
  out.set_slanted();
  // What stretches all edges within 1/1000 alike is as good as a turn.
  const int64_t lesser = turn_q17 < mirror_q17 ? turn_q17 : mirror_q17;
  constexpr int64_t kOneQ15 = 1 << 15;
  if (lesser * 2048 > turn_q17 + mirror_q17) {
    // Below one, so that the style is known as stretched.
    const int64_t gain_q15 = (least_q17 << 4) / size_q6;
    out.least_gain_q15_ =
        static_cast<uint16_t>(gain_q15 < kOneQ15 ? gain_q15 : kOneQ15 - 1);
  }
  return Status::ok;
}

bool is_same(const Style& a, const Style& b) noexcept {
  return a.size_q6_ == b.size_q6_ && a.axes_.x_right == b.axes_.x_right &&
         a.axes_.x_up == b.axes_.x_up && a.axes_.y_right == b.axes_.y_right &&
         a.axes_.y_up == b.axes_.y_up && a.filter_ == b.filter_ &&
         a.painter_ == b.painter_ && a.fitter() == b.fitter() &&
         a.fitter_options_ == b.fitter_options_ &&
         a.effect_.mixer == b.effect_.mixer &&
         a.effect_.options == b.effect_.options;
}

}  // namespace inkcell
