// Background pictures for drawing.
#pragma once

#include <filesystem>

#include "model/project.hpp"
#include "model/value.hpp"

namespace inkcell::design {

/// The command set_image, without "glyph", that puts a PNG behind a glyph: as
/// high as the em, its lower edge on the descender, its left edge on the
/// origin. It contains the file's bytes, under a name that is unique in the
/// project. Throws Error or std::runtime_error that names the file.
Value image_command(const Project& project, const std::filesystem::path& file);

}  // namespace inkcell::design
