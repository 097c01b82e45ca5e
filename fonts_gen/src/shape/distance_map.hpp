// Exact distances for very many queries, most of which need only bounds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shape/neighbourhood.hpp"
#include "shape/shape.hpp"

namespace inkcell {
namespace gen {

/// Square tiles around a shape. A distance changes by at most 1 u per u, so the
/// one at a tile's centre bounds all others in it, to half the diagonal.
/// Callers that only need the side of a ramp need no more. For the others a
/// tile holds the list of edges that matter in it, made at the first query.
///
/// Not thread-safe. Refers to the shape, which must not be empty and must
/// outlive it.
class DistanceMap {
 public:
  /// Queries may be in the shape's box and up to `margin_u` around it.
  DistanceMap(const Shape& shape, double margin_u);

  /// Whether queries may be at a point.
  bool holds(double x_u, double y_u) const;

  /// Bounds of the distances in a tile. [u]
  struct Bounds {
    double low = 0;
    double high = 0;
  };
  const Bounds& bounds(double x_u, double y_u) const {
    return bounds_[tile_of(x_u, y_u)];
  }

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
  Square square_of(size_t tile) const;
  size_t block_of(size_t tile) const;

  double x0_u_ = 0;  // lower left corner of the first tile
  double y0_u_ = 0;
  size_t tiles_x_ = 0;
  size_t tiles_y_ = 0;
  std::vector<Bounds> bounds_;         // of the tiles, row by row from below
  std::vector<Neighbourhood> blocks_;  // row by row from below
  std::vector<Neighbourhood> lists_;   // of tiles that were queried
  std::vector<uint32_t> list_of_;      // of each tile in lists_, plus one
};

}  // namespace gen
}  // namespace inkcell
