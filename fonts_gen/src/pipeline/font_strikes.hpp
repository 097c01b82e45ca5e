// Strikes of a font: pictures of its glyphs, beside its outlines or alone.
#pragma once

#include "pipeline/request.hpp"
#include "rom/rom_content.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// Makes the strikes of `request` from the outlines of `content`, by the
/// device's own fitting. With request.strike_only, or if glyphs of `font` are
/// pictures, the first one and those pictures are all that `content` keeps.
/// Throws Error, also if the device draws them otherwise.
void add_strikes(const GenerateRequest& request,
                 const SourceFont& font,
                 RomContent& content);

}  // namespace inkcell::gen
