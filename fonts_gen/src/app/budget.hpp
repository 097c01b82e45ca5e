// The finest font that fits into a number of bytes.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "pipeline/generate.hpp"

namespace inkcell::gen {

/// Reads "24K", "24576" or "1M"; K is 1024 bytes. Throws Error for others and
/// for 0.
size_t parse_bytes(const std::string& text);

/// Generates fonts with tolerances of kFinest to kCoarsest, by bisection, and
/// returns the finest that has at most `budget` bytes. The tolerance of
/// `request` is not used. Glyphs may miss the default tolerance and coarser
/// ones; a finer one that a glyph misses does not fit.
/// Calls `tell` with a line for each trial.
///
/// Throws what generate() throws for the coarsest, and Error if even that is
/// larger; it names the glyphs that cost most.
inline constexpr int kFinest = 1;  // [1/255]
inline constexpr int kCoarsest = 64;
RomFont generate_within(GenerateRequest request,
                        size_t budget,
                        const std::function<void(const std::string&)>& tell);

}  // namespace inkcell::gen
