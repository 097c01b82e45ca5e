// TTF and OTF as projects.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "model/project.hpp"
#include "source/char_set.hpp"

namespace inkcell::design {

/// What becomes of glyphs that the file makes of others.
enum class Composites { keep, decompose };

/// Reads the glyphs of `characters`, all that the font maps if it is empty, and
/// .notdef. Points stay as they are in the file: quadratics with implied
/// points, or cubics. Kerning becomes pairs of groups. Advances, vertical
/// measures, names of glyphs and of the font are taken.
///
/// Composite glyphs keep their components, and the glyphs that they refer to
/// are added, without code points if `characters` lacks them; those whose
/// components do not give the exact points of the file get contours, and all
/// with Composites::decompose.
///
/// Throws gen::Error that names the file and the glyph.
Project import_font(const std::filesystem::path& file,
                    const gen::CharSet& characters,
                    gen::Warnings& warnings,
                    Composites composites = Composites::keep);

}  // namespace inkcell::design
