// Fast sweeping: distances spread from the edge in four orders.
#include "inkcell/simulation/redistance.hpp"

#include "base/known_span.hpp"
#include "base/math.hpp"
#include "limits.hpp"

namespace inkcell::simulation {
namespace {

constexpr int32_t kSide = 32;  // of a sample, in units of its value
constexpr int32_t kDeepest = 127;

// sqrt(2 h^2 - d^2) for differences d from 0 to h, to the nearest.
struct Roots {
  uint8_t of[kSide + 1];
};

constexpr Roots make_roots() noexcept {
  Roots roots = {};
  for (uint32_t d = 0; d <= kSide; ++d) {
    roots.of[d] = static_cast<uint8_t>(
        detail::nearest_root_of(2 * kSide * kSide - d * d));
  }
  return roots;
}

constexpr Roots kRoots = make_roots();

// The magnitude of a value: 0 inside is half a step, -1 outside too.
int32_t depth(int32_t value) noexcept {
  return value < 0 ? -1 - value : value;
}

int8_t with_side(int32_t depth, bool is_inside) noexcept {
  return static_cast<int8_t>(is_inside ? depth : -1 - depth);
}

// A sample; outside of the grid the nearest one.
int32_t nearest(const DistanceGrid& grid, int32_t x, int32_t y) noexcept {
  const int32_t right = grid.width() - 1;
  const int32_t bottom = grid.height() - 1;
  return grid.at(clamp(x, 0, right), clamp(y, 0, bottom));
}

bool is_edge(const DistanceGrid& grid, int32_t x, int32_t y) noexcept {
  if (x > 0 && y > 0 && x + 1 < grid.width() && y + 1 < grid.height()) {
    const int8_t* at = grid.row(y) + x;
    const int32_t stride = grid.width();
    return ((*at ^ at[-1]) | (*at ^ at[1]) | (*at ^ at[-stride]) |
            (*at ^ at[stride])) < 0;
  }
  const bool side = grid.at(x, y) < 0;
  return (nearest(grid, x - 1, y) < 0) != side ||
         (nearest(grid, x + 1, y) < 0) != side ||
         (nearest(grid, x, y - 1) < 0) != side ||
         (nearest(grid, x, y + 1) < 0) != side;
}

// The slope along an axis: to the neighbour across the edge, to the farther one
// of two; without an edge between both neighbours.
int32_t slope(int32_t value, int32_t before, int32_t after) noexcept {
  const bool side = value < 0;
  const int32_t back = abs(before - value);
  const int32_t ahead = abs(after - value);
  const bool has_back = (before < 0) != side;
  const bool has_ahead = (after < 0) != side;
  if (has_back && has_ahead) {
    return max(back, ahead);
  }
  if (has_back || has_ahead) {
    return has_back ? back : ahead;
  }
  return abs(after - before) >> 1;
}

// The known samples of a row and its neighbours, plus `by` on both sides.
detail::KnownSpan span_around(const DistanceGrid& grid,
                              int32_t y,
                              int32_t by) noexcept {
  return grown(detail::known_span(grid, y - 1, y + 1), by, grid.width());
}

// Rows [first, end).
struct Rows {
  int32_t first;
  int32_t end;
};

// Sets samples next to the edge to value / slope, within 3 %, and all others to
// far. Copies other rows.
void mark(const DistanceGrid& from,
          const Rows& rows,
          DistanceGrid& to) noexcept {
  for (int32_t y = 0; y < from.height(); ++y) {
    if (y < rows.first || y >= rows.end) {
      __builtin_memcpy(to.row(y), from.row(y),
                       static_cast<size_t>(from.width()));
      continue;
    }
    const detail::KnownSpan span = span_around(from, y, 1);
    detail::clear_around(span, to.row(y), to.width());
    for (int32_t x = span.first; x < span.end; ++x) {
      const int32_t value = from.row(y)[x];
      int32_t distance = kDeepest;
      if (is_edge(from, x, y)) {
        const int32_t across =
            slope(value, nearest(from, x - 1, y), nearest(from, x + 1, y));
        const int32_t along =
            slope(value, nearest(from, x, y - 1), nearest(from, x, y + 1));
        const int32_t length = near_length(across, along);
        // There is an edge, so it is at least 1. A depth is half a step less
        // than the distance.
        const int32_t found = (2 * depth(value) + 1) * (kSide / 2) / length;
        distance = min(found, kDeepest);
      }
      to.row(y)[x] = with_side(distance, value >= 0);
    }
  }
}

// Updates a sample that has neighbours on all sides, none of them across the
// edge. `stride` leads to the next row.
void spread_to(int8_t* at, int32_t stride) noexcept {
  const int32_t value = *at;
  const int32_t left = at[-1];
  const int32_t right = at[1];
  const int32_t above = at[-stride];
  const int32_t below = at[stride];
  if (((value ^ left) | (value ^ right) | (value ^ above) | (value ^ below)) <
      0) {
    return;  // next to the edge: kept
  }
  // All are on one side: an exclusive or maps values to depths and back.
  const int32_t side = value >> 31;
  const int32_t a = min(left ^ side, right ^ side);
  const int32_t b = min(above ^ side, below ^ side);
  const int32_t difference = abs(a - b);
  const int32_t found = difference >= kSide
                            ? min(a, b) + kSide
                            : (a + b + kRoots.of[difference]) >> 1;
  if (found < (value ^ side)) {
    *at = static_cast<int8_t>(found ^ side);
  }
}

}  // namespace

void redistance(const DistanceGrid& grid,
                DistanceGrid& out,
                int32_t first_row,
                int32_t end_row) noexcept {
  if (grid.width() != out.width() || grid.height() != out.height() ||
      grid.width() == 0) {
    return;
  }
  const Rows rows = {max(first_row, 0), min(end_row, out.height())};
  mark(grid, rows, out);
  // The outermost samples keep what mark() gave them.
  const int32_t width = out.width();
  const int32_t height = out.height();
  for (int32_t order = 0; order < 4; ++order) {
    const int32_t step = (order & 1) != 0 ? -1 : 1;
    const int32_t top = max(rows.first, 1);
    const int32_t bottom = min(rows.end, height - 1);
    const int32_t down = (order & 2) != 0 ? -1 : 1;
    int32_t y = down > 0 ? top : bottom - 1;
    const auto known = [&](int32_t row) {
      return detail::known_span(out.row(row), width);
    };
    if (top >= bottom) {
      return;
    }
    detail::KnownSpan behind = known(y - down);
    detail::KnownSpan here = known(y);
    for (int32_t i = top; i < bottom; ++i, y += down) {
      const detail::KnownSpan ahead = known(y + down);
      // Distances reach 4 samples: no other samples change.
      const detail::KnownSpan span =
          grown(united(behind, united(here, ahead)), 5, width);
      const int32_t first = max(span.first, 1);
      const int32_t end = min(span.end, width - 1);
      int8_t* at = out.row(y) + (step > 0 ? first : end - 1);
      for (int32_t x = first; x < end; ++x, at += step) {
        spread_to(at, width);
      }
      behind = known(y);
      here = ahead;
    }
  }
}

}  // namespace inkcell::simulation
