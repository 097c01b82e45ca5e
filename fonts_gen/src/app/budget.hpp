// The finest font that fits a number of bytes.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "pipeline/generate.hpp"

namespace inkcell::gen {

/// Parses "24K", "24576" or "1M"; K is 1024 bytes. Throws Error for anything
/// else and for 0.
size_t parse_bytes(const std::string& text);

/// Generates fonts with tolerances of kFinest to kCoarsest, by bisection, and
/// returns the finest that has at most `budget` bytes. Ignores the tolerance of
/// `request`. Glyphs may miss the default tolerance and coarser ones; a finer
/// one that a glyph misses counts as too large. Calls `tell` with a line for
/// each trial.
///
/// Throws what generate() throws for the coarsest, and Error if even that is
/// too large; it names the glyphs that cost most.
inline constexpr int kFinest = 1;  // [1/255]
inline constexpr int kCoarsest = 64;
RomFont generate_within(GenerateRequest request,
                        size_t budget,
                        const std::function<void(const std::string&)>& tell);

}  // namespace inkcell::gen
