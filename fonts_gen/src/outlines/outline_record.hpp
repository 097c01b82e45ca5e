// Records of outlines and composites (docs/FORMAT.md, "Glyph record").
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "outlines/outline_code.hpp"
#include "outlines/outline_steps.hpp"
#include "source/components.hpp"

namespace inkcell::gen {

/// The record of a glyph with ink. `code` must have a word for every step.
///
/// Throws GeometryError::too_large if it has not.
std::vector<uint8_t> outline_record(const std::vector<OutlineStep>& steps,
                                    const OutlineCode& code);

/// Bits of that record before trailing zeros are left out.
size_t outline_bits(const std::vector<OutlineStep>& steps,
                    const OutlineCode& code);

/// Whether all numbers fit a record, and no matrix mirrors.
bool fits_record(const OutlineReferences& references);

/// The record of a glyph of components for which fits_record() is true.
std::vector<uint8_t> composite_record(const OutlineReferences& references);

/// Bits of that record before trailing zeros are left out.
size_t composite_bits(const OutlineReferences& references);

}  // namespace inkcell::gen
