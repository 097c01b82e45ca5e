// What Font::verify asks of MORP.
#pragma once

#include <stdint.h>

#include "inkcell/span.hpp"

namespace inkcell::detail {

// Whether pairs ascend and name glyphs that exist, a glyph has one second
// master at most, and no record makes more points than the section says. An
// empty section fits.
bool morphs_fit(const Span<const uint8_t>& section,
                uint32_t glyph_count) noexcept;

}  // namespace inkcell::detail
