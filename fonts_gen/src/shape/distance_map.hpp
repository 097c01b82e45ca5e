// Exact distances at very many points of a glyph, most of them for nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "shape/neighbourhood.hpp"
#include "shape/shape.hpp"

namespace inkcell {
namespace gen {

/// The plane around a shape in square tiles. A distance changes by at most 1 u
/// per u, so that the one at a tile's centre bounds all others in it: half the
/// diagonal more or less. Who only asks on which side of a ramp a point lies
/// has his answer without measuring. For the others a tile holds the list of
/// edges that matter in it, made when first asked for.
///
/// Not for several threads at once; refers to the shape, which must not be
/// empty and must outlive it.
class DistanceMap {
 public:
  /// Points may be asked for in the shape's box and up to `margin_u` around.
  DistanceMap(const Shape& shape, double margin_u);

  /// No distance in the tile is outside of this. [u]
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
  std::vector<Neighbourhood> lists_;   // of those tiles that were asked for
  std::vector<uint32_t> list_of_;      // of each tile in lists_, plus one
};

}  // namespace gen
}  // namespace inkcell
