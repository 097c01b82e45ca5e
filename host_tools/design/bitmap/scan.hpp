// Scans of paper: converts grey under uneven light to ink and paper.
#pragma once

#include "bitmap/bitmap.hpp"
#include "bitmap/edge_walk.hpp"

namespace inkcell::design {

/// Evens out slowly changing light: fits the grey of the paper by a polynomial
/// of second degree in x and y (least squares) and makes it white. Unchanged if
/// there is too little paper.
void level_light(Bitmap& scan);

/// Evens out the light and divides into ink and paper by otsu_threshold(). A
/// scan of less than 1024 px/em is first enlarged by an integer of up to 8, as
/// interpolated greys locate the edge between its pixels. The place and the
/// least area in `options` are adapted to the result; a tolerance of 0 becomes
/// that of the scan's own pixels.
void divide_scan(Bitmap& scan, MasterOptions& options);

}  // namespace inkcell::design
