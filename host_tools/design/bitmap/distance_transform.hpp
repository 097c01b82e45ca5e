// The exact distance transform of a bi-level bitmap.
#pragma once

#include <vector>

#include "bitmap/bitmap.hpp"

namespace inkcell::design {

/// Signed distance of each pixel's centre from the edge, positive inside, row
/// by row from the top. [px] The paper's way from masters to fields: the
/// Euclidean distance to the nearest pixel of the other kind, which is exact in
/// linear time (Maurer, Qi and Raghavan 2003; here by lower envelopes of
/// parabolas, Felzenszwalb and Huttenlocher 2012), less the half pixel by which
/// the edge lies between the centres of two.
std::vector<float> signed_distances(const Bitmap& bitmap);

}  // namespace inkcell::design
