// How a morph looks in pixels.
#pragma once

#include "morph/morph_pair.hpp"

namespace inkcell::gen {

/// Whether one of the 31 frames between two glyphs shows what it must not, at
/// 24, 48 or 96 px/em where strokes of both glyphs have 1.5 px:
/// more holes or islands than both glyphs have at that size, as where the mouth
/// of a bay is narrower than a pixel; or, for the second frame in a row, a hole
/// or an island of fewer than 2 px. Pixels are ink where about half is covered.
bool has_blemish(const MorphPair& pair);

}  // namespace inkcell::gen
