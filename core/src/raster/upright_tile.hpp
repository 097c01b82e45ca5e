// Tiles of upright maps.
#pragma once

#include "inkcell/text_style.hpp"
#include "place/cell_raster.hpp"

namespace inkcell {
namespace detail {

extern const CellRaster kUprightCells;

inline const CellRaster& raster_of(const TextStyle& style) noexcept {
  return style.is_upright() ? kUprightCells : style.slanted_cells();
}

}  // namespace detail
}  // namespace inkcell
