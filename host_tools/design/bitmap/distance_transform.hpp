// The exact distance transform of a bi-level bitmap.
#pragma once

#include <vector>

#include "bitmap/bitmap.hpp"

namespace inkcell::design {

/// The signed distance of each pixel's centre from the edge, positive inside,
/// row by row from the top. [px] As in the paper: the Euclidean distance to the
/// nearest pixel of the other kind, exact in linear time (Maurer, Qi and
/// Raghavan 2003; here by lower envelopes of parabolas, Felzenszwalb and
/// Huttenlocher 2012), less half a pixel, as the edge is midway between two
/// centres.
std::vector<float> signed_distances(const Bitmap& bitmap);

}  // namespace inkcell::design
