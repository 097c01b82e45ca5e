// Draws bodies at any angle; soft bodies deform each other.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/simulation/bodies.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell::simulation {

/// Draws body `index`. Soft bodies deform each other (Cani 1998; the paper,
/// figure 13): a pixel in two bodies belongs to the one in which it is deeper,
/// so both end at a common line. Beside it they bulge, so that their areas stay
/// the same: up to 1.3 px, and 2.6 px if a sample is 2 px wide or more; the
/// ring of the bulge is 4 samples wide. Bodies are clipped to the walls.
/// Neighbours are those in Body::touches, which step() writes.
///
/// Cost: about 70 instructions for each pixel near the edge, and as many for
/// each neighbour; runs inside cost little. The picture does not depend on the
/// window.
void draw_body(Span<const Body> bodies,
               size_t index,
               const BodyRules& rules,
               const Filter& filter,
               const Sink& sink) noexcept;

}  // namespace inkcell::simulation
