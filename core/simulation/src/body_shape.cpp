// Sums over samples, and Newton's method to find the edge.
#include "inkcell/simulation/body_shape.hpp"

#include "base/known_span.hpp"
#include "inkcell/motion/numbers.hpp"
#include "limits.hpp"

namespace inkcell::simulation {
namespace {

constexpr size_t kLeastPoints = 8;
constexpr size_t kLeastGroup = 6;

int32_t squared(const BodyPoint& a, const BodyPoint& b) noexcept {
  const int32_t x = a.x_q5 - b.x_q5;
  const int32_t y = a.y_q5 - b.y_q5;
  return x * x + y * y;
}

// Lets each point be followed by the nearest one of the rest.
void line_up(BodyPoint* from, const BodyPoint* end) noexcept {
  for (; from + 1 < end; ++from) {
    BodyPoint* nearest = from + 1;
    for (BodyPoint* point = nearest; point != end; ++point) {
      nearest =
          squared(*from, *point) < squared(*from, *nearest) ? point : nearest;
    }
    const BodyPoint next = from[1];
    from[1] = *nearest;
    *nearest = next;
  }
}

}  // namespace

// Coordinates are doubled, so that sample centres are integers.
bool BodyShape::weigh() noexcept {
  int32_t sum = 0;  // at most 2^24, as sides are below 2^9 px
  int64_t x_sum = 0;
  int64_t y_sum = 0;
  for (int32_t y = 0; y < grid_.height(); ++y) {
    const int8_t* row = grid_.row(y);
    int32_t row_sum = 0;
    for (int32_t x = 0; x < grid_.width(); ++x) {
      const int32_t weight = DistanceGrid::coverage_of(row[x]);
      row_sum += weight;
      x_sum += weight * (2 * x + 1);
    }
    sum += row_sum;
    y_sum += row_sum * (2 * y + 1);
  }
  if (sum == 0) {
    return false;
  }
  const int32_t scale = grid_.scale_log2();
  // [1/16]
  const auto x_middle = static_cast<int32_t>((x_sum * 16 + sum / 2) / sum);
  const auto y_middle = static_cast<int32_t>((y_sum * 16 + sum / 2) / sum);
  centre_x_.raw = x_middle * (1 << (11 + scale));
  centre_y_.raw = y_middle * (1 << (11 + scale));
  int64_t squares = 0;
  for (int32_t y = 0; y < grid_.height(); ++y) {
    const int8_t* row = grid_.row(y);
    const int32_t down = (2 * y + 1) * 16 - y_middle;
    for (int32_t x = 0; x < grid_.width(); ++x) {
      const int32_t right = (2 * x + 1) * 16 - x_middle;
      squares += DistanceGrid::coverage_of(row[x]) *
                 (int64_t{right} * right + down * down);
    }
  }
  // A square has a sixth of its side squared of its own. [Q10]
  const auto gyration = static_cast<int32_t>(squares / sum) + 1024 / 6;
  gyration_q8_ = max((gyration << (2 * scale)) >> 2, 64);
  area_ = max(1, (sum << (2 * scale)) >> 6);
  return true;
}

void BodyShape::measure() noexcept {
  const int32_t right = grid_.width() - 1;
  const int32_t bottom = grid_.height() - 1;
  int32_t most = DistanceGrid::kOutside;
  int32_t near = 0;  // samples in a band of two sides around the edge
  for (int32_t y = 0; y <= bottom; ++y) {
    most = max(most, max(grid_.at(0, y), grid_.at(right, y)));
    for (int32_t x = 0; x <= right; ++x) {
      near += grid_.at(x, y) >= -32 && grid_.at(x, y) < 32 ? 1 : 0;
    }
  }
  for (int32_t x = 0; x <= right; ++x) {
    most = max(most, max(grid_.at(x, 0), grid_.at(x, bottom)));
  }
  // The border is half a sample beyond the outermost centres.
  const int32_t unit = 32 << grid_.scale_log2();
  margin_q10_ = max(-most - 1, 0) * unit;
  // The ink of a stroke is as wide as two depths and half as long as its edge.
  depth_q10_ = grid_.area() * unit / max(near, 1);
  spacing_q5_ = near << (4 + grid_.scale_log2());  // if there is one point
}

// Finds the edge from the middle of four samples.
bool BodyShape::find_edge_point(int32_t column,
                                int32_t row,
                                BodyPoint& out,
                                bool& is_corner) const noexcept {
  const int32_t inside = (grid_.at(column, row) >= 0 ? 1 : 0) +
                         (grid_.at(column + 1, row) >= 0 ? 1 : 0) +
                         (grid_.at(column, row + 1) >= 0 ? 1 : 0) +
                         (grid_.at(column + 1, row + 1) >= 0 ? 1 : 0);
  if (inside == 0 || inside == 4) {
    return false;
  }
  const int32_t scale = grid_.scale_log2();
  Q16_16 x = Q16_16::from_raw((column + 1) << (16 + scale));
  Q16_16 y = Q16_16::from_raw((row + 1) << (16 + scale));
  GridPoint here = probe(grid_, x, y);
  for (int32_t i = 0; i < 4; ++i) {
    // Slopes and distances here are below 8: 32 bits hold products of Q7 and
    // Q13. One more half step is enough.
    x.raw -= (here.distance_q10 >> 3) * here.x_slope_q13 / 16;
    y.raw -= (here.distance_q10 >> 3) * here.y_slope_q13 / 16;
    here = probe(grid_, x, y);
  }
  if (abs(here.distance_q10) > 128 << scale) {
    return false;
  }
  // At straight edges a point 1.5 sides farther in is as much deeper.
  const int32_t in = 3 << scale;
  const GridPoint deep =
      probe(grid_, Q16_16::from_raw(x.raw + here.x_slope_q13 * 4 * in),
            Q16_16::from_raw(y.raw + here.y_slope_q13 * 4 * in));
  is_corner = deep.distance_q10 < 1330 << scale;
  const int32_t limit = INT16_MAX;
  out.x_q5 = static_cast<int16_t>(
      clamp((x.raw - centre_x_.raw + 1024) >> 11, -limit, limit));
  out.y_q5 = static_cast<int16_t>(
      clamp((y.raw - centre_y_.raw + 1024) >> 11, -limit, limit));
  return true;
}

// Points at least this far apart. Returns one more than `room` holds if they do
// not fit.
size_t BodyShape::spread(int32_t spacing_q5, Span<BodyPoint> room) noexcept {
  size_t count = 0;
  for (int32_t pass = 0; pass < 2; ++pass) {
    // Closer at corners, so that a point is on the tip.
    const int32_t apart_q5 = pass == 0 ? spacing_q5 / 4 : spacing_q5;
    for (int32_t row = -1; row < grid_.height(); ++row) {
      for (int32_t column = -1; column < grid_.width(); ++column) {
        BodyPoint point;
        bool is_corner = false;
        if (!find_edge_point(column, row, point, is_corner) ||
            is_corner != (pass == 0)) {
          continue;
        }
        bool is_free = true;
        for (size_t i = 0; i < count && is_free; ++i) {
          const int32_t x = abs(room[i].x_q5 - point.x_q5);
          const int32_t y = abs(room[i].y_q5 - point.y_q5);
          is_free = x >= apart_q5 || y >= apart_q5 ||
                    x * x + y * y >= apart_q5 * apart_q5;
        }
        if (!is_free) {
          continue;
        }
        if (count == room.size) {
          return room.size + 1;
        }
        room[count++] = point;
      }
    }
    corner_count_ = pass == 0 ? count : corner_count_;
  }
  return count;
}

void BodyShape::group() noexcept {
  const size_t least = (points_.size + kMostGroups - 1) / kMostGroups;
  group_size_ = least < kLeastGroup ? kLeastGroup : least;
  for (size_t i = 0; i < points_.size; ++i) {
    const BodyPoint& first = points_[i - i % group_size_];
    const auto length = static_cast<int32_t>(
        length_of(points_[i].x_q5 - first.x_q5, points_[i].y_q5 - first.y_q5));
    uint16_t& reach = reach_[i / group_size_];
    reach = static_cast<uint16_t>(max(reach, (length >> 5) + 1));
  }
}

Status BodyShape::make(const DistanceGrid& grid,
                       Span<BodyPoint> room) noexcept {
  if (room.size < kLeastPoints) {
    return Status::buffer_small;
  }
  if (grid.width_px() > kMostSidePx || grid.height_px() > kMostSidePx) {
    return Status::bad_argument;
  }
  BodyShape made;
  made.grid_ = grid;
  if (!made.weigh()) {
    return Status::bad_argument;
  }
  made.measure();
  // 8 points fit if they are as far apart as the grid is wide.
  constexpr int32_t kMostSpacingQ5 = kMostSidePx << 5;
  int32_t spacing_q5 = 48 << grid.scale_log2();
  size_t count = made.spread(spacing_q5, room);
  while (count > room.size && spacing_q5 < kMostSpacingQ5) {
    spacing_q5 += spacing_q5 >> 2;
    count = made.spread(spacing_q5, room);
  }
  if (count == 0 || count > room.size) {
    return Status::bad_argument;
  }
  line_up(room.data, room.data + made.corner_count_);
  line_up(room.data + made.corner_count_, room.data + count);
  made.points_ = {room.data, count};
  made.group();
  const auto halves = static_cast<int32_t>(2 * count - made.corner_count_);
  made.spacing_q5_ = max(1, 2 * made.spacing_q5_ / halves);
  for (const BodyPoint& point : made.points_) {
    const auto length = static_cast<int32_t>(length_of(point.x_q5, point.y_q5));
    made.radius_ = max(made.radius_, (length >> 5) + 1);
  }
  made.per_area_q30_ = (1 << 30) / made.area_;
  made.per_gyration_q20_ = (1 << 28) / made.gyration_q8_;
  made.per_radius_q23_ = (1 << 23) / max(made.radius_, 1);
  *this = made;
  return Status::ok;
}

}  // namespace inkcell::simulation
