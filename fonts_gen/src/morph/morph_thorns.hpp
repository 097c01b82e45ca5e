// Thorns of a morph: corners on the way that neither glyph has there.
#pragma once

#include <vector>

#include "morph/morph_check.hpp"

namespace inkcell::gen {

/// How much farther contours turn on the way than at both of their ends: the
/// sum over the thorns of a frame, in the mean of all between the ends.
/// [degrees] `frames`: from end to end, with the same points. [u] Contours that
/// are born count as smooth.
double thorns_of(const std::vector<MorphPolygons>& frames);

/// The same of a pair, in kMorphSteps.
double thorns_of(const MorphPair& pair);

}  // namespace inkcell::gen
