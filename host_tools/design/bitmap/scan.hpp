// Scans of paper: from greys under uneven light to ink and none.
#pragma once

#include "bitmap/bitmap.hpp"
#include "bitmap/edge_walk.hpp"

namespace inkcell::design {

/// Evens out light that changes slowly over the sheet: the grey of the paper as
/// a polynomial of second degree of the place, found by least squares, becomes
/// white. Unchanged if there is too little paper to tell.
void level_light(Bitmap& scan);

/// Levels the light and divides into ink and paper by otsu_threshold(). A scan
/// of less than 1024 px/em is first enlarged by a whole number of up to 8:
/// interpolated greys tell where the edge is between its pixels. The place and
/// the least area in `options` become those of the result; a tolerance of 0
/// becomes that of the scan's own pixels.
void divide_scan(Bitmap& scan, MasterOptions& options);

}  // namespace inkcell::design
