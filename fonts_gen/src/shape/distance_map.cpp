#include "shape/distance_map.hpp"

#include <algorithm>
#include <cmath>

namespace inkcell::gen {

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
  lists_.emplace_back(shape, Square{x0_u_, y0_u_, width_u});
  blocks_.resize(blocks_x * blocks_y);
  tiles_.resize(tiles_x_ * tiles_y_);
}

bool DistanceMap::holds(double x_u, double y_u) const {
  return x_u >= x0_u_ && y_u >= y0_u_ &&
         x_u < x0_u_ + static_cast<double>(tiles_x_) * kTile_u &&
         y_u < y0_u_ + static_cast<double>(tiles_y_) * kTile_u;
}

double DistanceMap::distance(double x_u, double y_u) {
  return list_of(tile_of(x_u, y_u)).distance(x_u, y_u);
}

const Neighbourhood& DistanceMap::list_of(size_t tile) {
  if (tiles_[tile] == 0) {
    const size_t column = tile % tiles_x_ / kBlockTiles;
    const size_t row = tile / tiles_x_ / kBlockTiles;
    uint32_t& block = blocks_[row * (tiles_x_ / kBlockTiles) + column];
    const auto add_part = [&](uint32_t of, const Square& square) {
      lists_.push_back(lists_[of].part(square));
      return static_cast<uint32_t>(lists_.size() - 1);
    };
    if (block == 0) {
      block = add_part(0, square_at(column, row, kTile_u * kBlockTiles));
    }
    tiles_[tile] =
        add_part(block, square_at(tile % tiles_x_, tile / tiles_x_, kTile_u));
  }
  return lists_[tiles_[tile]];
}

Square DistanceMap::square_at(size_t column, size_t row, double size_u) const {
  return {x0_u_ + static_cast<double>(column) * size_u,
          y0_u_ + static_cast<double>(row) * size_u, size_u};
}

}  // namespace inkcell::gen
