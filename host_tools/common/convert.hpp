// Font files as programs take them: a ROM font, or one converted in memory.
#pragma once

#include <filesystem>
#include <string>

#include "generate.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {

/// Opens `file`. A ROM font is read as it is; any other font file is converted
/// by the generator under `request`, with the characters of `text` (UTF-8)
/// besides those that the request names. Warnings go to standard error.
///
/// Throws std::runtime_error.
RomFile load_font_file(const std::filesystem::path& file,
                       gen::GenerateRequest request,
                       const std::string& text);

}  // namespace inkcell::tools
