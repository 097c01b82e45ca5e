// Two loops that mirror themselves: so does what is between them.
#pragma once

#include <optional>

#include "morph/match_loops.hpp"

namespace inkcell::gen {

/// The best match of which one half mirrors the other. None: a loop is not the
/// mirror image of itself, or both are about axes of different directions.
std::optional<LoopMatch> match_mirrored(const Loop& a,
                                        const Loop& b,
                                        const MatchOptions& options);

}  // namespace inkcell::gen
