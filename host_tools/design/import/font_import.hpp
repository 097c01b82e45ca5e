// TTF and OTF as projects.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "model/project.hpp"
#include "source/char_set.hpp"

namespace inkcell::design {

/// Reads the glyphs of `characters`, all that the font maps if it is empty, and
/// .notdef. Points stay as they are in the file: quadratics with implied
/// points, or cubics; components become contours. Kerning becomes pairs of
/// groups. Advances, vertical measures, names of glyphs and of the font are
/// taken.
///
/// Throws gen::Error that names the file and the glyph.
Project import_font(const std::filesystem::path& file,
                    const gen::CharSet& characters,
                    gen::Warnings& warnings);

}  // namespace inkcell::design
