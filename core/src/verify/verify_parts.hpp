// What Font::verify asks of outlines and of MORP.
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

// Whether pairs ascend and name glyphs that exist, a glyph has one second
// master at most, and no record makes more points than the section says. An
// empty section fits.
bool morphs_fit(const Span<const uint8_t>& section,
                uint32_t glyph_count) noexcept;

}  // namespace inkcell::detail
