// How styles of one kind draw cells.
#pragma once

#include <stdint.h>

#include "inkcell/render.hpp"
#include "inkcell/strip.hpp"
#include "inkcell/text_style.hpp"
#include "place/cell_map.hpp"

namespace inkcell {
namespace detail {

class CellBand;
struct Stretching;

// Fills rows of a clear tile, kTileColumns pixels apart. False: they stay 0.
using CoverTile = bool (*)(const CellBand& band,
                           const GlyphPoint& first,
                           int32_t width,
                           int32_t height,
                           uint8_t* lines) noexcept;

// Of slanted styles it is linked with the make() that needs it.
struct CellRaster {
  // Sets map.samples and map.first. False: nothing shows in the window.
  bool (*clip)(CellMap& map, const Rect& window) noexcept;
  // CellMap::find, of maps that may not be near; null: they are.
  bool (*find)(const CellMap& map,
               int32_t x,
               int32_t y,
               GlyphPoint& out) noexcept;
  CoverTile cover;
  const Stretching* stretching;  // null: edges are stretched alike

  // Whether a tile may show something, given where its first sample lies. Tiles
  // of less than 2^13 u that begin farther away than 2^15 u lie in no grid, nor
  // do those that begin nearer and pass that.
  bool may_show(const CellMap& map,
                int32_t x,
                int32_t y,
                GlyphPoint& at) const noexcept {
    return map.is_near || find(map, x, y, at);
  }
};

}  // namespace detail
}  // namespace inkcell
