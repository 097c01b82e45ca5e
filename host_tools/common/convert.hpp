// Font files as programs take them: a ROM font, or one converted in memory.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "pipeline/generate.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {

/// How a font file that is no ROM font becomes one.
struct Conversion {
  gen::GenerateRequest request;
  /// If a glyph is too complex for it, the largest size may be halved.
  bool may_halve = true;
  /// The first of the options that the person gave, empty if there is none.
  std::string option;
};

/// Adds the options of inkcell-fontgen, listed apart in the help.
void add_conversion_options(CLI::App& app, gen::GenerateRequest& request);

/// `request`, after the arguments were parsed. A largest size that the person
/// gave stays as it is.
Conversion conversion_of(const CLI::App& app,
                         const gen::GenerateRequest& request);

/// Opens `file`. A ROM font is read as it is, and refused if there is an option
/// to convert it under; any other font file is converted by the generator, with
/// the characters of `text` (UTF-8) besides those that the request names. If it
/// may, it tries again with half the largest size, down to the smallest, and
/// says so. Warnings go to standard error, and progress, unless the request has
/// a function for it.
///
/// Throws std::runtime_error, also for a damaged ROM font that is not to be
/// shown.
enum class Damaged { refused, shown };
RomFile load_font_file(const std::filesystem::path& file,
                       const Conversion& conversion,
                       const std::string& text,
                       Damaged damaged = Damaged::refused);

}  // namespace inkcell::tools
