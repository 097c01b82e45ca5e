// Font files as programs take them: a ROM font, or one converted in memory.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "generate.hpp"
#include "rom_file.hpp"

namespace inkcell::tools {

/// Adds the options of inkcell-fontgen, listed apart in the help.
void add_conversion_options(CLI::App& app, gen::GenerateRequest& request);

/// What becomes of the largest size if a glyph is too complex for it.
enum class MaxPx { asked_for, may_halve };

/// asked_for if the person gave --max-px.
inline MaxPx max_px_of(const CLI::App& app) {
  return app.count("--max-px") != 0 ? MaxPx::asked_for : MaxPx::may_halve;
}

/// Opens `file`. A ROM font is read as it is, under no request; any other font
/// file is converted by the generator under `request`, with the characters of
/// `text` (UTF-8) besides those that the request names. If it may, it tries
/// again with half the largest size, down to the smallest, and says so.
/// Warnings go to standard error.
///
/// Throws std::runtime_error.
RomFile load_font_file(const std::filesystem::path& file,
                       gen::GenerateRequest request,
                       const std::string& text,
                       MaxPx max_px);

}  // namespace inkcell::tools
