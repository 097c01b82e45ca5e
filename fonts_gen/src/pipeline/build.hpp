// All glyphs of a font, from outlines to what the ROM font says of them.
#pragma once

#include <vector>

#include "judge/closed_loop.hpp"
#include "pipeline/request.hpp"
#include "rom/rom_content.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// Builds every glyph of `font`, on request.threads threads. `errors` gets what
/// the device draws of each. Glyphs that nothing needs are dropped from `font`,
/// and its kerning is moved to the result. Throws Error.
RomContent build_content(SourceFont& font,
                         const GenerateRequest& request,
                         std::vector<GlyphErrors>& errors);

/// Builds a part of the glyphs of an outline font into request.built_glyphs.
/// The parts take about equally long. Throws Error.
void build_part(const SourceFont& font,
                const GenerateRequest& request,
                GlyphPart part);

}  // namespace inkcell::gen
