// The morphs of a font: from the texts of a request to records.
#pragma once

#include "base/error.hpp"
#include "pipeline/request.hpp"
#include "rom/rom_content.hpp"

namespace inkcell::gen {

/// Adds the characters that the texts of `request` name. Throws Error if a text
/// names fewer than two in a group.
void add_morph_characters(const GenerateRequest& request, CharSet& characters);

/// Pairs the outlines of `content` that the texts name, and the masters of each
/// glyph; its records must be encoded, its glyphs are those of `font`. A pair
/// for which no way is found is left out, with a warning.
void add_morphs(const GenerateRequest& request,
                const SourceFont& font,
                RomContent& content,
                Warnings& warnings);

}  // namespace inkcell::gen
