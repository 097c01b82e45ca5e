// Columns that sink, and edges that move towards others.
#include "inkcell/simulation/melt.hpp"

#include "inkcell/motion/numbers.hpp"
#include "limits.hpp"

namespace inkcell::simulation {
namespace {

int8_t sample_of(int32_t value) noexcept {
  return static_cast<int8_t>(clamp(value, INT8_MIN, INT8_MAX));
}

// Smooth noise: the speed of a column. [of 256]
int32_t speed_of(uint32_t seed, int32_t column, int32_t wide) noexcept {
  const int32_t part = column % wide;
  const auto noise = [&](int32_t knot) {
    const auto at = static_cast<uint32_t>(column / wide + knot);
    return static_cast<int32_t>(hash(seed, at) >> 24);
  };
  const int32_t both = noise(0) * (wide - part) + noise(1) * part;
  return 86 + both * 2 / (3 * wide);
}

}  // namespace

void melt(DistanceGrid& grid,
          const Melting& how,
          GridHistogram& scratch) noexcept {
  const int32_t speed_q8 = clamp(how.speed_q8, 0, 4 * 256);
  const int32_t floor_q6 = clamp(how.floor.raw, -(1 << 19), 1 << 19);
  const int32_t shift = grid.scale_log2() + 1;
  const int32_t beside = clamp(how.beside.raw, 0, 1 << 19) >> shift;
  const int32_t added = -cutoff_for(grid, how.area, scratch).raw / 64;
  // As deep as one of this area, from side to side.
  const int32_t wide = max(grid.width() * 16 - beside, 16);  // half of it
  const int32_t deep = how.area / wide * 8 + how.area % wide * 8 / wide;
  const int32_t drip =
      clamp(how.drip.raw >> (grid.scale_log2() + 6), 1, 128);  // [samples]
  const int32_t depth = max(deep + 32, 24 * drip);
  const int32_t slow = 20 * drip;  // the height of slow samples
  // All is outside of the known samples, and stays so.
  const Rect known = grid.known_box();
  const int32_t stride = grid.width();
  for (int32_t x = known.x0; x < known.x1; ++x) {
    int8_t* const column = grid.row(0) + x;
    const auto sample = [&](int32_t y) -> int32_t {
      return y < 0 ? DistanceGrid::kOutside : column[y * stride];
    };
    const int32_t speed = speed_q8 * speed_of(how.seed, x, drip);
    const int32_t side = 32 * min(x, stride - 1 - x) + 16 - beside;
    // Upwards: the sample above is still that of the step before.
    for (int32_t y = grid.height() - 1; y >= known.y0; --y) {
      // Of the sample's middle above the floor. [1/32 of a sample]
      const int32_t height = (floor_q6 - ((2 * y + 1) << (shift + 4))) >> shift;
      const int32_t fall_q8 =
          height >= slow ? speed >> 8 : speed * max(height, 0) / (slow * 256);
      const int32_t from = y - (fall_q8 >> 8);
      const int32_t below = sample(from);
      const int32_t above = sample(from - 1);
      const int32_t fallen =
          below + (((above - below) * (fall_q8 & 255) + 128) >> 8);
      const bool is_puddle = fallen > INT8_MIN && height < depth;
      column[y * stride] = sample_of(
          min(is_puddle ? fallen + added : fallen, min(height, side)));
    }
  }
}

void freeze(DistanceGrid& grid,
            const DistanceGrid& target,
            int32_t most) noexcept {
  if (grid.width() != target.width() || grid.height() != target.height()) {
    return;
  }
  most = clamp(most, 1, 255);
  for (int32_t y = 0; y < grid.height(); ++y) {
    int8_t* row = grid.row(y);
    const int8_t* wanted = target.row(y);
    for (int32_t x = 0; x < grid.width(); ++x) {
      const int32_t far = min(most, 10 + abs(wanted[x]) / 3);
      row[x] = sample_of(clamp(wanted[x], row[x] - far, row[x] + far));
    }
  }
}

}  // namespace inkcell::simulation
