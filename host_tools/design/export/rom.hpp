// Projects as Inkcell fonts.
#pragma once

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

}  // namespace inkcell::design
