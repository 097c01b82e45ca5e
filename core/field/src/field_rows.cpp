#include "field_rows.hpp"

#include "base/math.hpp"
#include "place/style_parts.hpp"
#include "row_painter.hpp"

namespace inkcell::detail {
namespace {

// Columns of a row.
struct Columns {
  int32_t begin;
  int32_t end;
};

// After how many steps a place reaches `at_q16`, `most` at the most.
int32_t steps_to(int64_t at_q16,
                 int64_t from_q16,
                 int32_t step_q16,
                 int32_t most) noexcept {
  int64_t left_q16 = at_q16 - from_q16;
  if (left_q16 <= 0) {
    return 0;
  }
  if (left_q16 > int64_t{step_q16} * most) {
    return most;
  }
  // At first too few: without a division of 64 bits.
  auto steps = static_cast<int32_t>(static_cast<uint32_t>(left_q16 >> 8) /
                                    static_cast<uint32_t>((step_q16 >> 8) + 1));
  left_q16 -= int64_t{step_q16} * steps;
  for (; left_q16 > 0; left_q16 -= step_q16) {
    ++steps;
  }
  return steps;
}

// Leaves those columns whose places along one axis lie in [low_u, high_u).
void clip(Columns& columns,
          int64_t first_q16,
          int32_t step_q16,
          int32_t low_u,
          int32_t high_u) noexcept {
  int64_t low_q16 = int64_t{low_u} * (1 << 16);
  int64_t high_q16 = int64_t{high_u} * (1 << 16);
  if (step_q16 == 0) {
    if (first_q16 < low_q16 || first_q16 >= high_q16) {
      columns.end = columns.begin;
    }
    return;
  }
  if (step_q16 < 0) {
    step_q16 = -step_q16;
    first_q16 = -first_q16;
    const int64_t low = low_q16;
    low_q16 = 1 - high_q16;
    high_q16 = 1 - low;
  }
  columns.begin =
      max(columns.begin, steps_to(low_q16, first_q16, step_q16, columns.end));
  columns.end = steps_to(high_q16, first_q16, step_q16, columns.end);
}

template <typename Bytes>
__attribute__((noinline)) void fill_rows(const FieldRows& rows,
                                         const Band& band,
                                         const BandScale& scale,
                                         FieldPlace first) noexcept {
  const GlyphField& field = rows.field();
  const Rect& limits = rows.limits();
  const GlyphStep& right = rows.right();
  const bool is_upright = rows.style().is_upright();
  const Columns all = {0, band.last_column + 1};
  Columns columns = all;
  clip(columns, first.x_q16, right.x_q16, limits.x0, limits.x1);
  for (int32_t row = 0; row != band.rows; ++row) {
    if (!is_upright && row != 0) {
      columns = all;
      clip(columns, first.x_q16, right.x_q16, limits.x0, limits.x1);
    }
    Columns own = columns;
    clip(own, first.y_q16, right.y_q16, limits.y0, limits.y1);
    if (own.begin < own.end) {
      FieldPlace at = first;
      at.move(right, own.begin);
      FieldRow painter = {
          {field},
          rows,
          scale,
          static_cast<uint32_t>(at.x_q16) -
              (static_cast<uint32_t>(field.x0_u) << 16),
          static_cast<uint32_t>(at.y_q16) -
              (static_cast<uint32_t>(field.y0_u) << 16),
      };
      Bytes bytes(scale);
      uint8_t* const out = band.row(row);
      if (is_upright) {
        painter.paint(bytes, out + own.begin, out + own.end);
      } else {
        painter.paint_leaning(bytes, out + own.begin, out + own.end);
      }
    }
    first.move(rows.up(), -1);
  }
}

GlyphStep part_of(const GlyphStep& step, int32_t number) noexcept {
  return number == 1 ? step
                     : GlyphStep{step.x_q16 / number, step.y_q16 / number,
                                 step.x_q20 / number, step.y_q20 / number};
}

}  // namespace

bool FieldRows::open(const GlyphField& field,
                     const Style& style,
                     const Placed& placed,
                     int32_t shown_q8,
                     int32_t columns,
                     int32_t rows) noexcept {
  field_ = &field;
  style_ = &style;
  columns_ = static_cast<uint8_t>(columns);
  rows_ = static_cast<uint8_t>(rows);
  right_ = part_of(style.right(), columns);
  up_ = part_of(style.up(), rows);
  x_q10_ = int64_t{placed.x_q10} * columns;
  y_q10_ = int64_t{placed.y_q10} * rows;
  const int32_t least_q6 =
      style.size().raw * (StyleParts::least_gain_q15(style) >> 5) >> 10;
  const int32_t shown_u = (shown_q8 << 8) / max(least_q6, 1) + 1;
  const InkBox& ink = field.ink;
  limits_ = intersect({field.x0_u, field.y0_u, field.x1_u(), field.y1_u()},
                      {ink.x0_u - shown_u, ink.y0_u - shown_u,
                       ink.x1_u + shown_u, ink.y1_u + shown_u});
  return !is_empty(limits_);
}

Rect FieldRows::box(const Placed& placed) const noexcept {
  struct Extent {
    int32_t low;
    int32_t high;
  };
  const auto px_q10 = [this](int32_t low_u, int32_t high_u) noexcept {
    const int32_t size_q6 = style_->size().raw;
    return Extent{(low_u * size_q6) >> 6, (high_u * size_q6) >> 6};
  };
  const auto turned = [](const Extent& at, Fixed<int32_t, 30> by) noexcept {
    const auto low = static_cast<int32_t>((int64_t{at.low} * by.raw) >> 30);
    const auto high = static_cast<int32_t>((int64_t{at.high} * by.raw) >> 30);
    return low < high ? Extent{low, high} : Extent{high, low};
  };
  Extent x = px_q10(limits_.x0, limits_.x1);
  Extent y = px_q10(limits_.y0, limits_.y1);
  // From a pixel's edge to the centre of its first sample, and room for steps
  // that are rounded. [px]
  int32_t half_x = columns_ == 1 ? 512 : 170;
  int32_t half_y = rows_ == 1 ? 512 : 170;
  if (!style_->is_upright()) {
    const Style::Axes& axes = style_->axes();
    const Extent x_right = turned(x, axes.x_right);
    const Extent y_right = turned(y, axes.y_right);
    const Extent x_up = turned(x, axes.x_up);
    const Extent y_up = turned(y, axes.y_up);
    x = {x_right.low + y_right.low, x_right.high + y_right.high};
    y = {x_up.low + y_up.low, x_up.high + y_up.high};
    half_x = half_y = -512;
  }
  return {(placed.x_q10 + x.low + half_x - 1) >> 10,
          (placed.y_q10 - y.high + half_y - 1) >> 10,
          (placed.x_q10 + x.high - half_x + 1023) >> 10,
          (placed.y_q10 - y.low - half_y + 1023) >> 10};
}

FieldPlace FieldRows::place_of(int64_t x_q8, int64_t y_q8) const noexcept {
  // Far from anything to see they are clamped, to stay within 64 bits once
  // multiplied.
  constexpr int64_t kFar = int64_t{1} << 37;
  const auto clamped = [](int64_t at_q10) {
    return at_q10 < -kFar ? -kFar : at_q10 > kFar ? kFar : at_q10;
  };
  const int64_t right_q10 = clamped(x_q8 * 4 + 512 - x_q10_);
  const int64_t up_q10 = clamped(y_q10_ - (y_q8 * 4 + 512));
  return {(right_q10 * right_.x_q16 + up_q10 * up_.x_q16) >> 10,
          (right_q10 * right_.y_q16 + up_q10 * up_.y_q16) >> 10};
}

// A sample between two neighbours that are both outside, or both inside, tells
// whether a stroke or a gap passes there.
void FieldRows::fill_crossings(const Band& band,
                               FieldPlace first) const noexcept {
  constexpr int32_t kFar = 1 << 10;  // no edge is within a pixel
  const auto reach_q10 = static_cast<uint32_t>(band.reach_q8) * 4;
  FieldSampler sampler(*field_);
  const auto distance_q10 = [this, &sampler](const FieldPlace& at) noexcept {
    return screen_distance_q10(*style_, sampler, at);
  };
  for (int32_t row = 0; row != band.rows; ++row) {
    int32_t before = -1;
    FieldPlace at = first;
    first.move(up_, -1);
    uint8_t* out = band.row(row);
    for (uint8_t* const end = out + band.last_column + 1; out != end; ++out) {
      const int32_t own = distance_q10(at);
      const auto is_crossed = [&](const FieldPlace& other) noexcept {
        const FieldPlace middle = {(at.x_q16 + other.x_q16) >> 1,
                                   (at.y_q16 + other.y_q16) >> 1};
        return ((distance_q10(other) ^ own) | (distance_q10(middle) ^ own)) < 0;
      };
      uint32_t byte = (own ^ before) < 0 ? kInsideBit : 0;
      if (abs(own) < kFar) {
        const auto away =
            static_cast<uint32_t>(abs(own)) * kNearest / reach_q10;
        byte |= away < kNearest ? (2 * (kNearest - away)) & kNearnessMask : 0;
        FieldPlace left = at;
        left.move(right_, -1);
        FieldPlace above = at;
        above.move(up_, 1);
        byte |= is_crossed(left) ? kCrossedLeft : 0;
        byte |= is_crossed(above) ? kCrossedAbove : 0;
      }
      *out = static_cast<uint8_t>(byte);
      before = own;
      at.move(right_, 1);
    }
    *out = before >= 0 ? kInsideBit : 0;
  }
}

void FieldRows::fill(const Band& band,
                     BandBytes kind,
                     int32_t x_q8,
                     int32_t y_q8) const noexcept {
  const FieldPlace first = place_of(x_q8, y_q8);
  if (kind == BandBytes::crossings) {
    fill_crossings(band, first);
    return;
  }
  const bool is_area = kind == BandBytes::area;
  // Units of the band a pixel: 127 steps of its reach, or areas. A sample that
  // is a third of a pixel both ways has the ramp of one that is a pixel.
  const int32_t more = is_area && columns_ == rows_ ? columns_ : 1;
  constexpr int32_t kLeastReach = 8;
  const int32_t per_px_q8 =
      is_area ? kFullArea * more * 256
              : kNearest * 256 * 256 / max(band.reach_q8, kLeastReach);
  BandScale scale;
  scale.of_distance =
      static_cast<int32_t>((int64_t{per_px_q8} * style_->size().raw) >> 8);
  scale.of_slope = (per_px_q8 << 5) / columns_;
  scale.is_thin_right = is_area && columns_ > rows_;
  scale.is_thin_up = is_area && rows_ > columns_;
  if (is_area) {
    fill_rows<AreaBytes>(*this, band, scale, first);
  } else {
    fill_rows<DistanceBytes>(*this, band, scale, first);
  }
}

}  // namespace inkcell::detail
