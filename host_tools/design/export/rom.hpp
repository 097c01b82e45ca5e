// Projects as Inkcell fonts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "export/ttf.hpp"
#include "model/project.hpp"
#include "pipeline/generate.hpp"

namespace inkcell::design {

/// The generator's font of the project as TrueType (ttf.hpp), with the options
/// of `request`, whose font is ignored. All characters of the project, unless
/// the request names some. Throws Error or gen::Error.
gen::RomFont make_rom(const Project& project,
                      gen::GenerateRequest request,
                      TtfReport* report = nullptr);

/// Replaces a file by these bytes, whole or not at all. Throws gen::Error.
void write_bytes(const std::filesystem::path& file,
                 const std::vector<uint8_t>& bytes);

}  // namespace inkcell::design
