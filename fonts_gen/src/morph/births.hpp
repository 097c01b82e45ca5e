// Births: where a contour appears that one glyph lacks.
#pragma once

#include <vector>

#include "morph/morph_loop.hpp"
#include "morph/morph_pair.hpp"

namespace inkcell::gen {

/// `loop` as it grows from points of the medial axis of `glyph`, which is the
/// outline number `missing` of the pair: the nearest and deepest first.
std::vector<MorphContour> births_of(const Loop& loop,
                                    const std::vector<Loop>& glyph,
                                    int missing);

}  // namespace inkcell::gen
