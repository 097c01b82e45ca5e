// Exact distances for many queries.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shape/neighbourhood.hpp"
#include "shape/shape.hpp"

namespace inkcell::gen {

/// Square tiles around a shape. A tile holds the list of edges that matter in
/// it, made at the first query.
///
/// Not thread-safe. Refers to the shape, which must not be empty and must
/// outlive it.
class DistanceMap {
 public:
  /// Queries may be in the shape's box and up to `margin_u` around it.
  DistanceMap(const Shape& shape, double margin_u);

  /// Whether queries may be at a point.
  bool holds(double x_u, double y_u) const;

  /// The same as Shape::distance.
  double distance(double x_u, double y_u);

 private:
  static constexpr double kTile_u = 16;
  // Tiles share the list of a block of kBlockTiles x kBlockTiles until they
  // have their own.
  static constexpr size_t kBlockTiles = 4;

  size_t tile_of(double x_u, double y_u) const {
    const auto column = static_cast<size_t>((x_u - x0_u_) * (1 / kTile_u));
    const auto row = static_cast<size_t>((y_u - y0_u_) * (1 / kTile_u));
    return row * tiles_x_ + column;
  }
  // The square of `size_u` that begins so many such squares from the corner.
  Square square_at(size_t column, size_t row, double size_u) const;
  const Neighbourhood& list_of(size_t tile);

  double x0_u_ = 0;  // lower left corner of the first tile
  double y0_u_ = 0;
  size_t tiles_x_ = 0;
  size_t tiles_y_ = 0;
  std::vector<Neighbourhood> lists_;  // the first is that of the whole
  // Of each block and tile, row by row from below: its list, 0 if there is none
  // yet.
  std::vector<uint32_t> blocks_;
  std::vector<uint32_t> tiles_;
};

}  // namespace inkcell::gen
