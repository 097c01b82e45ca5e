#include "target/grid.hpp"

#include <algorithm>
#include <cmath>

#include "inkcell/format/rom.hpp"

namespace inkcell::gen {

namespace {

constexpr int kTileLog2 = 8;
constexpr int kSmallestTileLog2Fixed = 6;
constexpr int kMaxTiles = 255;
constexpr int kGridLimit_u = format::glyph::kGridLimit;

static_assert(kCoordinateLimit + 768.0 / 4 + (1 << kTileLog2) <= kGridLimit_u,
              "the format must hold the grid of every outline");

[[noreturn]] void throw_too_large(const char* what) {
  throw GeometryError(GeometryError::Kind::too_large, what);
}

int tiles_for(double extent_u, int tile_log2) {
  return std::max(
      1, static_cast<int>(std::ceil(std::ldexp(extent_u, -tile_log2))));
}

}  // namespace

Grid lay_grid(const Shape& shape, const Target& options) {
  const double band = band_u(options);
  const Box& ink = shape.box();
  const Box box{ink.x0 - band, ink.y0 - band, ink.x1 + band, ink.y1 + band};
  const bool fixed = options.predicate == Predicate::fixed;
  Grid grid;
  grid.tile_log2 = fixed ? kSmallestTileLog2Fixed : kTileLog2;
  const double extent = std::max(box.x1 - box.x0, box.y1 - box.y0);
  while (fixed && (1 << grid.tile_log2) < extent &&
         grid.tile_log2 < static_cast<int>(format::glyph::kMaxTileLog2)) {
    ++grid.tile_log2;
  }
  // The grid begins on a whole u, at most 1 u before the box.
  grid.tiles_x = tiles_for(box.x1 - std::floor(box.x0), grid.tile_log2);
  grid.tiles_y = tiles_for(box.y1 - std::floor(box.y0), grid.tile_log2);
  if (grid.tiles_x > kMaxTiles || grid.tiles_y > kMaxTiles) {
    throw_too_large("the glyph needs more than 255 tiles in a row");
  }
  const double width = grid.tiles_x << grid.tile_log2;
  const double height = grid.tiles_y << grid.tile_log2;
  const double slack_x = fixed ? 0 : width - (box.x1 - std::floor(box.x0));
  const double slack_y = fixed ? 0 : height - (box.y1 - std::floor(box.y0));
  grid.x0_u = static_cast<int>(std::floor(box.x0) - std::floor(slack_x / 2));
  grid.y0_u = static_cast<int>(std::floor(box.y0) - std::floor(slack_y / 2));
  if (grid.x0_u < -kGridLimit_u || grid.x0_u + width > kGridLimit_u ||
      grid.y0_u < -kGridLimit_u || grid.y0_u + height > kGridLimit_u) {
    throw_too_large("the glyph reaches beyond 15 em from its origin");
  }
  return grid;
}

std::vector<CellSquare> tiles_of(const Grid& grid) {
  std::vector<CellSquare> tiles;
  for (int row = 0; row < grid.tiles_y; ++row) {
    for (int column = 0; column < grid.tiles_x; ++column) {
      tiles.push_back({grid.x0_u + (column << grid.tile_log2),
                       grid.y0_u + (row << grid.tile_log2), grid.tile_log2});
    }
  }
  return tiles;
}

}  // namespace inkcell::gen
