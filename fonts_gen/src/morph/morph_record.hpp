// A pair as the bytes that lie in section MORP (docs/FORMAT.md).
#pragma once

#include <cstdint>
#include <vector>

#include "morph/morph_pair.hpp"

namespace inkcell::gen {

/// The number that the device gives to the first point after the beginning of
/// each segment of a glyph.
using SegmentPoints = std::vector<int>;

/// The record. Throws GeometryError::too_complex if the pair has too many
/// points or pieces for the format.
std::vector<uint8_t> morph_record(const MorphPair& pair,
                                  const SegmentPoints (&points)[2]);

/// The most points that the device makes of the pair.
int morph_points(const MorphPair& pair);

}  // namespace inkcell::gen
