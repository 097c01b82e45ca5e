// Fast sweeping: distances spread from the edge in four orders.
#include "inkcell/simulation/redistance.hpp"

#include "base/known_span.hpp"
#include "base/math.hpp"
#include "limits.hpp"

namespace inkcell::simulation {
namespace {

constexpr int32_t kSide = 32;  // of a sample, in units of its value
constexpr int32_t kDeepest = 127;

// How much farther from the edge a sample is than the nearer one of two
// neighbours that differ by d, 0 to h: (d + sqrt(2 h^2 - d^2)) / 2.
struct Steps {
  uint8_t of[kSide + 1];
};

constexpr Steps make_steps() noexcept {
  Steps steps = {};
  for (uint32_t d = 0; d <= kSide; ++d) {
    const uint32_t root = detail::nearest_root_of(2 * kSide * kSide - d * d);
    steps.of[d] = static_cast<uint8_t>((d + root) / 2);
  }
  return steps;
}

constexpr Steps kSteps = make_steps();

// The magnitude of a value: 0 inside is half a step, -1 outside too.
int32_t depth(int32_t value) noexcept {
  return value < 0 ? -1 - value : value;
}

int8_t with_side(int32_t depth, bool is_inside) noexcept {
  return static_cast<int8_t>(is_inside ? depth : -1 - depth);
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
    // Outside of the grid: the nearest sample.
    const int8_t* const row = from.row(y);
    const int8_t* const before = from.row(max(y - 1, 0));
    const int8_t* const after = from.row(min(y + 1, from.height() - 1));
    int8_t* const marked = to.row(y);
    int32_t left = row[max(span.first - 1, 0)];
    int32_t value = row[min(span.first, from.width() - 1)];
    for (int32_t x = span.first; x < span.end; ++x) {
      const int32_t right = row[min(x + 1, from.width() - 1)];
      const int32_t above = before[x];
      const int32_t below = after[x];
      int32_t distance = kDeepest;
      if (((value ^ left) | (value ^ right) | (value ^ above) |
           (value ^ below)) < 0) {
        // At least 1. A depth is half a step less than the distance.
        const int32_t length =
            near_length(slope(value, left, right), slope(value, above, below));
        const int32_t found = (2 * depth(value) + 1) * (kSide / 2) / length;
        distance = min(found, kDeepest);
      }
      marked[x] = with_side(distance, value >= 0);
      left = value;
      value = right;
    }
  }
}

// Updates a sample that has neighbours on all sides, but for those next to the
// edge. `stride` leads to the next row.
void spread_to(int8_t* at, int32_t stride) noexcept {
  // An exclusive or maps values of this side to depths and back, and those of
  // the other side to negative numbers.
  const int32_t side = *at >> 31;
  const int32_t known = *at ^ side;
  if (known <= kSteps.of[0]) {
    return;  // the least that is found
  }
  const int32_t a = min(at[-1] ^ side, at[1] ^ side);
  const int32_t b = min(at[-stride] ^ side, at[stride] ^ side);
  const int32_t nearest = min(a, b);
  // Next to the edge, or none is nearer to it.
  if (nearest < 0 || nearest >= known - kSteps.of[0]) {
    return;
  }
  const int32_t found = nearest + kSteps.of[min(abs(a - b), kSide)];
  if (found < known) {
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
