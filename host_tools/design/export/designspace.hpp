// The sources of a variable font, for fontmake.
#pragma once

#include <filesystem>

#include "model/project.hpp"

namespace inkcell::design {

/// Writes a designspace of the font's axes (axes_of()), and beside it a UFO of
/// each master, its name and that of the master: `fontmake -m FILE -o variable`
/// makes the font. Throws Error that names the glyph and the points that do not
/// correspond.
void write_designspace(const Project& project,
                       const std::filesystem::path& file);

}  // namespace inkcell::design
