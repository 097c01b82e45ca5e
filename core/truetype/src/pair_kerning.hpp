// Kerning of a TrueType file: `kern` format 0, and pairs of GPOS.
#pragma once

#include "tables.hpp"

namespace inkcell::detail {

// Finds what pair_kerning() reads: GPOS, if that kerns, else `kern`.
void choose_kerning(const Table& kern,
                    const Table& gpos,
                    TrueTypeFace& face) noexcept;

// What to add to the advance of `left`. [font units]
int32_t pair_kerning(const TrueTypeFace& face,
                     uint32_t left,
                     uint32_t right) noexcept;

}  // namespace inkcell::detail
