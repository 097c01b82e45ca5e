// Imports TTF and OTF as projects.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "model/project.hpp"
#include "source/char_set.hpp"

namespace inkcell::design {

/// The treatment of composite glyphs in the file.
enum class Composites { keep, decompose };

/// Imports the glyphs of `characters`, or all that the font maps if it is
/// empty, and .notdef. Points are those of the file: quadratics with implied
/// points, or cubics. Kerning becomes pairs of groups. Advances, vertical
/// metrics, names of glyphs and of the font are imported.
///
/// Composite glyphs keep their components, and the glyphs that they refer to
/// are added, without code points if `characters` lacks them. Composites whose
/// components do not give the exact points of the file get contours; with
/// Composites::decompose all do.
///
/// Throws gen::Error that names the file and the glyph.
Project import_font(const std::filesystem::path& file,
                    const gen::CharSet& characters,
                    gen::Warnings& warnings,
                    Composites composites = Composites::keep);

/// Makes a project of a font: a folder that does not exist. `chars` are ranges
/// of characters. Returns for messages what was taken, then line by line the
/// tables that import_font() does not read, with the scripts, features and
/// number of lookups of GSUB and GPOS. Throws Error or gen::Error.
std::string import_project(const std::filesystem::path& file,
                           const std::filesystem::path& folder,
                           const std::vector<std::string>& chars,
                           gen::Warnings& warnings,
                           Composites composites = Composites::keep);

}  // namespace inkcell::design
