// A census as text for people and as JSON.
#pragma once

#include <string>

#include "census.hpp"

namespace inkcell::tools {

std::string font_report(const FontCensus& font);
std::string glyph_report(const FontCensus& font, const GlyphCensus& glyph);

/// The font; if `glyph` is not null, that glyph alone in full.
std::string json_report(const FontCensus& font, const GlyphCensus* glyph);

}  // namespace inkcell::tools
