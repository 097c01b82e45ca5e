// Glyphs of cells by way of rows of signed distances: the station that outlines
// and cells share.
#pragma once

#include "inkcell/field.hpp"
#include "inkcell/render.hpp"
#include "inkcell/text_style.hpp"
#include "place/cell_raster.hpp"
#include "raster/cell_band.hpp"
#include "rows/mixer.hpp"

namespace inkcell {
namespace detail {

using MixCells = void (*)(GlyphJob& job);

// Fills bands of signed distances and hands them to `mix`. A byte v stands for
// (2 v - 255) / 254 of the reach, the greater one of the plan; 0 and 255 for
// all that is farther. `stripes`: bands of what these paint, three bytes a
// pixel.
void mix_cells(const GlyphField& field,
               const TextStyle& style,
               const FinePoint& origin,
               const Sink& sink,
               const BandPlan& plan,
               const Stripes* stripes,
               MixCells mix) noexcept;

// From these bytes to nearness and toggles, as outlines are job.
void toggle_rows(const Band& band) noexcept;

}  // namespace detail
}  // namespace inkcell
