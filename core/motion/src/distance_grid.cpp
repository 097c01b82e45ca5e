// A sink whose coverage is distance.
#include "inkcell/motion/distance_grid.hpp"

#include "base/known_span.hpp"
#include "inkcell/geometry.hpp"
#include "inkcell/painter.hpp"
#include "inkcell/shadow.hpp"
#include "inkcell/style.hpp"
#include "limits.hpp"

namespace inkcell::motion {
namespace {

static_assert(detail::kOutside == DistanceGrid::kOutside, "the same sample");

void keep_greater(int8_t& sample, int32_t value) noexcept {
  sample = static_cast<int8_t>(value > sample ? value : sample);
}

void unite_coverage(void* context,
                    int32_t x,
                    int32_t y,
                    const uint8_t* coverage,
                    int32_t count) {
  int8_t* row = static_cast<DistanceGrid*>(context)->row(y) + x;
  for (int32_t i = 0; i < count; ++i) {
    keep_greater(row[i], coverage[i] - 128);
  }
}

void unite_solid(void* context, int32_t x, int32_t y, int32_t count) {
  int8_t* row = static_cast<DistanceGrid*>(context)->row(y) + x;
  for (int32_t i = 0; i < count; ++i) {
    row[i] = INT8_MAX;
  }
}

}  // namespace

// Entry i of the linear table is i: distances from i - 128 to i - 127 in 1/32
// px.
constexpr Filter kFilterDistance =
    make_filter({Q6_10::from_raw(-4096), Q6_10::from_raw(4096)});

DistanceGrid::DistanceGrid(Span<int8_t> samples,
                           int32_t width,
                           int32_t height,
                           int32_t scale_log2) noexcept {
  const bool is_valid = width >= 1 && width <= kMaxSide && height >= 1 &&
                        height <= kMaxSide && scale_log2 >= 0 &&
                        scale_log2 <= kMaxScaleLog2 &&
                        static_cast<size_t>(width * height) <= samples.size;
  if (is_valid) {
    samples_ = samples.data;
    width_ = width;
    height_ = height;
    scale_log2_ = scale_log2;
  }
}

int32_t DistanceGrid::depth() const noexcept {
  int32_t most = 0;
  for (int32_t i = 0; i < width_ * height_; ++i) {
    most = max(most, samples_[i]);
  }
  return most;
}

int32_t DistanceGrid::area() const noexcept {
  int32_t sum = 0;
  for (int32_t i = 0; i < width_ * height_; ++i) {
    sum += coverage_of(samples_[i]);
  }
  return sum;
}

Rect DistanceGrid::known_box() const noexcept {
  Rect box;
  for (int32_t y = 0; y < height_; ++y) {
    const detail::KnownSpan known = detail::known_span(row(y), width_);
    if (known.first < known.end) {
      box = bounding_box(box, {known.first, y, known.end, y + 1});
    }
  }
  return box;
}

void DistanceGrid::clear() noexcept {
  for (int32_t i = 0; i < width_ * height_; ++i) {
    samples_[i] = kOutside;
  }
}

Sink DistanceGrid::sink() noexcept {
  Sink sink;
  sink.window = {0, 0, width_, height_};
  sink.context = this;
  sink.coverage = unite_coverage;
  sink.solid = unite_solid;
  return sink;
}

Status DistanceGrid::paint(const Font& font,
                           uint16_t glyph,
                           Q26_6 size,
                           Point origin,
                           Workspace workspace) noexcept {
  const Q26_6 painted = Q26_6::from_raw(size.raw >> scale_log2_);
  if (painted.raw < kMinSize.raw || painted.raw > kMaxSize.raw) {
    return Status::bad_argument;
  }
  const Style style(painted, kFilterDistance);
  INKCELL_TRY(check_reach(font.range(), painted, kFilterDistance));
  const Point at = {Q26_6::from_raw(origin.x.raw >> scale_log2_),
                    Q26_6::from_raw(origin.y.raw >> scale_log2_)};
  Painter(sink(), workspace).glyph(font, style, at, glyph);
  return Status::ok;
}

GridPoint probe(const DistanceGrid& grid, Q16_16 x, Q16_16 y) noexcept {
  // From the centre of the first sample. [samples, Q15] Any place fits.
  const int32_t column_q15 = (x.raw >> (grid.scale_log2() + 1)) - (1 << 14);
  const int32_t row_q15 = (y.raw >> (grid.scale_log2() + 1)) - (1 << 14);
  const int32_t column = column_q15 >> 15;
  const int32_t row = row_q15 >> 15;
  const int32_t right = (column_q15 >> 7) & 255;
  const int32_t down = (row_q15 >> 7) & 255;
  int32_t corners[4];
  if (column >= 0 && row >= 0 && column + 1 < grid.width() &&
      row + 1 < grid.height()) {
    const int8_t* top = grid.row(row) + column;
    const int8_t* bottom = top + grid.width();
    corners[0] = top[0];
    corners[1] = top[1];
    corners[2] = bottom[0];
    corners[3] = bottom[1];
  } else {
    corners[0] = grid.at(column, row);
    corners[1] = grid.at(column + 1, row);
    corners[2] = grid.at(column, row + 1);
    corners[3] = grid.at(column + 1, row + 1);
  }
  const int32_t top_step = corners[1] - corners[0];
  const int32_t bottom_step = corners[3] - corners[2];
  const int32_t top = corners[0] * 256 + top_step * right;
  const int32_t bottom = corners[2] * 256 + bottom_step * right;
  GridPoint point;
  // A sample stands for the middle of its step. [Q13 of a sample]
  const int32_t distance = top + ((bottom - top) * down >> 8) + 128;
  point.distance_q10 = distance * (1 << grid.scale_log2()) >> 3;
  point.x_slope_q13 = top_step * 256 + (bottom_step - top_step) * down;
  point.y_slope_q13 = bottom - top;
  return point;
}

}  // namespace inkcell::motion
