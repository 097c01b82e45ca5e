#include "shape/distance_map.hpp"

#include <algorithm>
#include <cmath>

namespace inkcell {
namespace gen {

DistanceMap::DistanceMap(const Shape& shape, double margin_u) {
  constexpr double kBlock_u = kTile_u * kBlockTiles;
  const Box& box = shape.box();
  x0_u_ = std::floor((box.x0 - margin_u) / kBlock_u) * kBlock_u;
  y0_u_ = std::floor((box.y0 - margin_u) / kBlock_u) * kBlock_u;
  // One more than the quotient, for queries at the far ends.
  const auto blocks = [&](double first, double last) {
    return static_cast<size_t>((last + margin_u - first) / kBlock_u) + 1;
  };
  const size_t blocks_x = blocks(x0_u_, box.x1);
  const size_t blocks_y = blocks(y0_u_, box.y1);
  tiles_x_ = blocks_x * kBlockTiles;
  tiles_y_ = blocks_y * kBlockTiles;
  const double width_u =
      static_cast<double>(std::max(blocks_x, blocks_y)) * kBlock_u;
  const Neighbourhood whole(shape, {x0_u_, y0_u_, width_u});
  blocks_.reserve(blocks_x * blocks_y);
  for (size_t y = 0; y < blocks_y; ++y) {
    for (size_t x = 0; x < blocks_x; ++x) {
      blocks_.push_back(
          whole.part({x0_u_ + static_cast<double>(x) * kBlock_u,
                      y0_u_ + static_cast<double>(y) * kBlock_u, kBlock_u}));
    }
  }
  // Half the diagonal, rounded up.
  constexpr double kReach_u = 0.7072 * kTile_u;
  const size_t tiles = tiles_x_ * tiles_y_;
  list_of_.resize(tiles);
  bounds_.reserve(tiles);
  for (size_t tile = 0; tile < tiles; ++tile) {
    const Square square = square_of(tile);
    const double centre = blocks_[block_of(tile)].distance(
        square.x + kTile_u / 2, square.y + kTile_u / 2);
    bounds_.push_back({centre - kReach_u, centre + kReach_u});
  }
}

bool DistanceMap::holds(double x_u, double y_u) const {
  return x_u >= x0_u_ && y_u >= y0_u_ &&
         x_u < x0_u_ + static_cast<double>(tiles_x_) * kTile_u &&
         y_u < y0_u_ + static_cast<double>(tiles_y_) * kTile_u;
}

double DistanceMap::distance(double x_u, double y_u) {
  const size_t tile = tile_of(x_u, y_u);
  if (list_of_[tile] == 0) {
    lists_.push_back(blocks_[block_of(tile)].part(square_of(tile)));
    list_of_[tile] = static_cast<uint32_t>(lists_.size());
  }
  return lists_[list_of_[tile] - 1].distance(x_u, y_u);
}

Square DistanceMap::square_of(size_t tile) const {
  return {x0_u_ + static_cast<double>(tile % tiles_x_) * kTile_u,
          y0_u_ + static_cast<double>(tile / tiles_x_) * kTile_u, kTile_u};
}

size_t DistanceMap::block_of(size_t tile) const {
  const size_t x = tile % tiles_x_ / kBlockTiles;
  const size_t y = tile / tiles_x_ / kBlockTiles;
  return y * (tiles_x_ / kBlockTiles) + x;
}

}  // namespace gen
}  // namespace inkcell
