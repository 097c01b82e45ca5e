// Draws bodies from their distances, in any turn; soft ones deform each other.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "inkcell/filter.hpp"
#include "inkcell/kinetic/bodies.hpp"
#include "inkcell/span.hpp"
#include "inkcell/strip.hpp"

namespace inkcell {
namespace kinetic {

/// Draws body `index`. With an overlap in `rules` bodies deform each other
/// (Cani 1998; the paper, figure 13): where two share a place, the one that is
/// deeper has it, so both end at one line and never overlap. Around it they
/// bulge, by their squeeze and at most by 2 px. What is beyond the walls is cut
/// off. At most 6 neighbours are looked at.
///
/// A body costs about 70 instructions for each pixel near its edge, and as many
/// more for each neighbour; runs inside cost little. The picture does not
/// depend on the window.
void draw_body(Span<const Body> bodies,
               size_t index,
               const BodyRules& rules,
               const Filter& filter,
               const Sink& sink) noexcept;

}  // namespace kinetic
}  // namespace inkcell
