// Slits: where a hole opens in ink that has none.
#pragma once

#include <vector>

#include "morph/morph_loop.hpp"
#include "morph/morph_pair.hpp"

namespace inkcell::gen {

/// Contours that open to `hole` from slits in the strokes of `glyph`, which is
/// the outline number `missing` of the pair: the nearest first.
std::vector<MorphContour> slits_for(const Loop& hole,
                                    const std::vector<Loop>& glyph,
                                    int missing);

}  // namespace inkcell::gen
