// The scripts that a font shapes on the device.
#pragma once

#include "base/error.hpp"
#include "pipeline/request.hpp"
#include "rom/rom_font.hpp"
#include "source/font_source.hpp"

namespace inkcell::gen {

/// Writes the font, with section SHAP if the request asks for it. The device's
/// code has then shaped random words and the texts of the request as HarfBuzz
/// does. Throws Error.
std::vector<uint8_t> write_shaped_font(const GenerateRequest& request,
                                       const SourceFont& font,
                                       RomContent& content,
                                       PartBytes& parts,
                                       Warnings& warnings);

}  // namespace inkcell::gen
