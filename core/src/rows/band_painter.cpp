// What filters and mixers name.
//
// A painter of outlines is linked into programs that name a filter which takes
// it, and that also open a font of outlines. Neither of the two is enough:
//
//   filter         --> BandPainter      - - weak - -> painter
//   kOutlineCoding --> outline_source.cpp ----------> the painter's object
//
// A weak reference takes no object from an archive, but keeps a function of one
// that is there. The linker drops the functions that no filter keeps.
#include "rows/band_painter.hpp"

#include "rows/cover_areas.hpp"
#include "rows/cover_distances.hpp"

namespace inkcell {
namespace detail {

__attribute__((weak)) PaintPoints paint_areas;
__attribute__((weak)) PaintPoints paint_crossings;
__attribute__((weak)) PaintPoints paint_distances;
__attribute__((weak)) PaintPoints paint_wide_distances;

const BandPainter kPaintPixelRamp = {paint_distances, cover_linear,
                                     BandKind::distance, true, 128};
const BandPainter kPaintDistances = {paint_distances, cover_filtered,
                                     BandKind::distance, false, 128};
const BandPainter kPaintWideDistances = {paint_wide_distances, cover_filtered,
                                         BandKind::distance, false, 0};
const BandPainter kPaintAreas = {paint_areas, cover_areas, BandKind::area,
                                 false, 128};
const BandPainter kPaintCrossings = {paint_crossings, nullptr,
                                     BandKind::crossings, false, 0};

}  // namespace detail
}  // namespace inkcell
