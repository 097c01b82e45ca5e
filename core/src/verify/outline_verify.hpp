// What Font::verify asks of outlines.
#pragma once

#include "inkcell/font.hpp"

namespace inkcell::detail {

// Whether the code words make sense (docs/FORMAT.md, rule 16).
bool code_fits(const OutlineCoding& coding) noexcept;

// Whether the record of an outline or a composite does (rules 17 and 18), and
// the bits before its hints, in a composite no more than that. Every code word
// of `coding` must.
bool outline_fits(const Font& font,
                  Span<const uint8_t> record,
                  const OutlineCoding& coding,
                  uint32_t& bits) noexcept;

}  // namespace inkcell::detail
