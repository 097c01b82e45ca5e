// How a morph looks in pixels.
#pragma once

#include "morph/morph_pair.hpp"

namespace inkcell::gen {

/// Frames that show what a morph must not show, of 31 at 24, 48 and 96 px/em
/// where strokes of both glyphs have 1.5 px:
/// more holes or islands than both glyphs have at that size, as where the mouth
/// of a bay is narrower than a pixel; or, for the second frame in a row, a hole
/// or an island of fewer than 2 px. Pixels are ink where about half is covered.
int blemished_frames(const MorphPair& pair);

}  // namespace inkcell::gen
