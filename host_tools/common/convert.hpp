// Loads a ROM font, or converts a font file in memory.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "pipeline/generate.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {

/// How to convert a font file.
struct Conversion {
  gen::GenerateRequest request;
  /// Whether the largest size may be halved if a glyph is too complex.
  bool may_halve = true;
  /// The first option for conversion on the command line; empty if none.
  std::string option;
};

/// Adds the options of inkcell-fontgen as a group of the help.
void add_conversion_options(CLI::App& app, gen::GenerateRequest& request);

/// `request` after parsing. A largest size on the command line is kept.
Conversion conversion_of(const CLI::App& app,
                         const gen::GenerateRequest& request);

/// Opens `file`. A ROM font is loaded, and refused if there are options for
/// conversion. Any other font file is converted by the generator, with the
/// characters of `text` (UTF-8) in addition to those of the request. If
/// allowed, retries with half the largest size, down to the smallest, and says
/// so. Warnings and progress go to standard error, unless the request has a
/// function for progress.
///
/// Throws std::runtime_error, also for a damaged ROM font with
/// Damaged::refused.
enum class Damaged { refused, shown };
RomFile load_font_file(const std::filesystem::path& file,
                       const Conversion& conversion,
                       const std::string& text,
                       Damaged damaged = Damaged::refused);

}  // namespace inkcell::tools
